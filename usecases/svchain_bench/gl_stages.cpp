#include "usecases/svchain_bench/gl_stages.h"

#include <epoxy/gl.h>

#include "algorithms/bowl/viewpoint_path.h"
#include "algorithms/car/default_car.h"
#include "algorithms/gl/bowl_renderer.h"
#include "usecases/svchain_bench/round_trips.h"

namespace svchain::bench {

namespace {

constexpr int kFrames = 60, kWarmUp = 5;
constexpr double kFps = 30;

/// Milliseconds until the stage is done, not only asked for.
double finished_ms(const std::function<void()>& stage) {
  const int64_t start_ns = now_ns();
  stage();
  glFinish();
  return static_cast<double>(now_ns() - start_ns) * 1e-6;
}

}  // namespace

GlStages gl_stages(const ParkedCar& car, const SynthesisScene& scene,
                   SynthesisScene::Pictures SynthesisScene::Set::*frames) {
  const geometry::Rig& rig = car.rig();
  const bowl::BowlSurface surface = bowl::default_surface(rig.vehicle);
  const bowl::ViewpointPath orbit = bowl::orbit(rig.vehicle, surface);
  std::vector<std::byte> mesh(bowl::mesh_table_capacity());
  mesh.resize(bowl::build_mesh_table(rig, surface, {}, bowl::kDefaultTolerancePx, mesh));
  cv::Mat picture(1080, 880, CV_8UC3);

  const gl::GlContext context;
  gl::BowlRenderer renderer(context, {picture.cols, picture.rows});
  renderer.set_mesh(bowl::MeshTable(mesh), rig);
  renderer.set_car(car::default_car(rig.vehicle), rig.vehicle);
  const gl::GlContext::Use use(context);
  std::vector<double> upload_ms, draw_ms, read_back_ms;
  for (int i = 0; i < kWarmUp + kFrames; ++i) {
    const auto& set = scene.sets[static_cast<size_t>(i) % scene.sets.size()];
    const bowl::Viewpoint viewpoint = orbit.at(i / kFps);
    upload_ms.push_back(finished_ms([&] { renderer.upload(set.*frames); }));
    draw_ms.push_back(finished_ms([&] { renderer.draw(scene.curves, viewpoint, 1); }));
    read_back_ms.push_back(finished_ms([&] { renderer.read_back(colour::bgr_picture(picture)); }));
  }
  for (auto* times : {&upload_ms, &draw_ms, &read_back_ms})
    times->erase(times->begin(), times->begin() + kWarmUp);
  return {median(upload_ms), median(draw_ms), median(read_back_ms)};
}

}  // namespace svchain::bench
