#include <opencv2/core.hpp>

#include "algorithms/bowl/mesh_table.h"
#include "algorithms/bowl/viewpoint_lut.h"
#include "algorithms/bowl/viewpoint_presets.h"
#include "algorithms/car/car_picture.h"
#include "algorithms/car/default_car.h"
#include "algorithms/gl/gl_context.h"
#include "usecases/svchain_bench/comparisons.h"
#include "usecases/svchain_bench/gl_stages.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/surround_view.h"
#include "usecases/svchain_bench/synthesis_scene.h"

namespace svchain::bench {

namespace {

const Eigen::Vector2i kPicture(880, 1080);

/// The rear chase of the parked car, and what is made for it.
struct ChaseView {
  explicit ChaseView(const geometry::Rig& rig)
      : surface(bowl::default_surface(rig.vehicle)),
        viewpoint(*bowl::preset("chase", rig.vehicle, surface)),
        maker(rig, surface, {}),
        memory(bowl::ViewpointLut::capacity(kPicture)),
        car(car::default_car(rig.vehicle), rig.vehicle) {
    make_lut();
    draw_car();
  }
  void make_lut() { lut_bytes = maker.build(viewpoint, kPicture, memory); }
  void draw_car() { car.render(car::seen_from(viewpoint, kPicture)); }
  synthesis::GeometricLut lut() const { return synthesis::GeometricLut(std::span(memory).first(lut_bytes)); }

  bowl::BowlSurface surface;
  bowl::Viewpoint viewpoint;
  bowl::ViewpointLut maker;
  std::vector<std::byte> memory;
  size_t lut_bytes = 0;
  car::CarPicture car;
};

double median_ms(int rounds, const std::function<void()>& work) {
  std::vector<double> times_ms;
  for (int round = 0; round < rounds; ++round) {
    const int64_t start_ns = now_ns();
    work();
    times_ms.push_back(static_cast<double>(now_ns() - start_ns) * 1e-6);
  }
  return median(times_ms);
}

/// Of a whole use case, frames from memory.
double fps(const ParkedCar& car, const UseCase& use_case) {
  constexpr int kRounds = 5, kFrames = 60;
  std::vector<double> frames_ms;
  for (int round = 0; round < kRounds; ++round)
    frames_ms.push_back(use_case_frame_ms(car, kFrames, use_case));
  return 1000 / median(frames_ms);
}

bool has_gl() {
  try {
    const gl::GlContext context;
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

void stages(Results& results, const ParkedCar& car) {
  constexpr int kRounds = 21;
  ChaseView view(car.rig());
  results.figures["bowl.viewpoint_lut_ms"] = median_ms(kRounds, [&] { view.make_lut(); });
  results.figures["bowl.car_ms"] = median_ms(kRounds, [&] { view.draw_car(); });
  std::vector<std::byte> mesh(bowl::mesh_table_capacity());
  results.figures["bowl.mesh_table_ms"] = median_ms(
      3, [&] { bowl::build_mesh_table(car.rig(), view.surface, {}, bowl::kDefaultTolerancePx, mesh); });
}

/// One thread each, the same frames; statistics are a part of the 2D view and the car of the 3D view.
double standing_over_2d(const ParkedCar& car) {
  constexpr int kRounds = 31;
  SynthesisScene flat(car);
  const ChaseView view(car.rig());
  const synthesis::GeometricLut lut = view.lut();
  cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3);
  const auto time = [&](const std::function<void(const SynthesisScene::Set&)>& way) {
    const int64_t start_ns = now_ns();
    for (const SynthesisScene::Set& set : flat.sets) way(set);
    return static_cast<double>(now_ns() - start_ns);
  };
  const synthesis::Kernel kernel = synthesis::best_kernel();
  return measure_paired(
             kRounds,
             [&] {
               return time([&](const SynthesisScene::Set& set) {
                 synthesis::synthesize(lut, set.bgr_pictures, flat.curves, colour::bgr_picture(picture),
                                       nullptr, kernel);
                 view.car.blend_over(picture);
               });
             },
             [&] {
               return time(
                   [&](const SynthesisScene::Set& set) { flat.synthesize(set.bgr_pictures, kernel); });
             })
      .ratio;
}

void stages_by_gl(Results& results, const ParkedCar& car) {
  const SynthesisScene scene(car);
  const GlStages bgr = gl_stages(car, scene, &SynthesisScene::Set::bgr_pictures);
  results.figures["bowl.gpu_upload_ms"] = bgr.upload_ms;
  results.figures["bowl.gpu_draw_ms"] = bgr.draw_ms;
  results.figures["bowl.gpu_read_back_ms"] = bgr.read_back_ms;
  const GlStages nv12 = gl_stages(car, scene, &SynthesisScene::Set::nv12_pictures);
  results.figures["bowl.gpu_upload_nv12_ms"] = nv12.upload_ms;
  results.figures["bowl.gpu_draw_nv12_ms"] = nv12.draw_ms;
}

}  // namespace

void compare_bowl(Results& results, const Progress& progress) {
  const ParkedCar car;
  progress("bowl stages");
  stages(results, car);
  progress("bowl.cpu_static_over_2d");
  results.figures["bowl.cpu_static_over_2d"] = standing_over_2d(car);
  progress("bowl.cpu_moving_fps");
  results.figures["bowl.cpu_moving_fps"] = fps(car, {"3dsv_cpu", {"cpus.DSP2=2"}});
  if (!has_gl()) return;
  progress("bowl.gpu_fps");
  results.figures["bowl.gpu_fps"] = fps(car, {"3dsv", {}});
  results.figures["bowl.gpu_standing_fps"] = fps(car, {"3dsv", {"bowl_view.viewpoint=chase"}});
  results.figures["bowl.gpu_nv12_fps"] = fps(car, {"3dsv", {"capture.format=nv12"}});
  progress("bowl stages by OpenGL ES");
  stages_by_gl(results, car);
}

}  // namespace svchain::bench
