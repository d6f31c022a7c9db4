#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>

#include "algorithms/calibration/scene_charts.h"
#include "algorithms/geometry/view.h"
#include "algorithms/scene/motion.h"
#include "algorithms/scene/nominal_rig.h"
#include "algorithms/scene/scene_file.h"
#include "algorithms/scene/still_renderer.h"
#include "algorithms/scene/top_view.h"
#include "algorithms/scene/truth_json.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/new_folder.h"
#include "usecases/svchain/png_text.h"
#include "usecases/svchain/run_numbers.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/shipped_files.h"

namespace svchain::program {

namespace {

std::atomic<bool> interrupted = false;  // set by Ctrl-C and SIGTERM, looked at between pictures

Result<scene::Scene> read_scene_of(const SimulateOptions& options) {
  auto file = find_file(kScenes, options.scene);
  if (file) return scene::read_scene(*file);
  for (Fault& fault : file.error()) fault.file = "--scene";
  return tl::unexpected(file.error());
}

std::filesystem::path picture_name(const std::string& camera, uint64_t frame, uint64_t frames) {
  const std::filesystem::path images = "images";
  if (frames == 1) return images / (camera + ".png");
  char name[32];
  std::snprintf(name, sizeof name, "%06llu.png", static_cast<unsigned long long>(frame));
  return images / camera / name;
}

void write_images(NewFolder& folder, const scene::StillRenderer& renderer, uint64_t frames) {
  const scene::Scene& scene = renderer.world().scene();
  for (uint64_t frame = 0; frame < frames; ++frame) {
    for (size_t camera = 0; camera < scene.rig.cameras.size() && !interrupted; ++camera) {
      const double time_s = static_cast<double>(scene::capture_time_ns(scene, camera, frame)) * 1e-9;
      folder.write(picture_name(scene.rig.cameras[camera].name, frame, frames),
                   png_text(renderer.render(camera, time_s, frame)));
    }
  }
}

void write_truth(NewFolder& folder, const scene::World& world) {
  const scene::Scene& scene = world.scene();
  geometry::View view;
  view.metres_per_px = geometry::default_metres_per_px(scene.rig.vehicle, view.size_px);
  folder.write("ground.png", png_text(scene::ideal_top_view(world, view, 0)));
  folder.write("truth.rig.json", geometry::rig_text(scene.rig));
  folder.write("nominal.rig.json", geometry::rig_text(scene::nominal_rig(scene)));
  folder.write("responses.json", scene::responses_text(scene.responses));
  if (!scene.charts.empty())
    folder.write("charts.json", calibration::charts_text(calibration::charts_of(scene)));
}

}  // namespace

int simulate(const SimulateOptions& options) {
  Faults faults;
  auto scene = read_scene_of(options);
  if (!scene) append(faults, scene.error());
  append(faults, NewFolder::check(options.output, "--output"));
  const uint64_t frames = read_whole_number("--frames", options.frames, {1, 999999}, faults).value_or(1);
  const uint64_t seed = read_whole_number("--seed", options.seed, {0, 1.8e19}, faults).value_or(1);
  if (!faults.empty()) return say(faults);
  scene->seed += seed - 1;         // 1, the usual one, leaves the scene's own
  scene->timestamp_jitter_ms = 0;  // pictures carry no time stamps that would tell of it

  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = true; });
  NewFolder folder(options.output);
  const scene::StillRenderer renderer(std::make_shared<const scene::World>(*std::move(scene)));
  write_images(folder, renderer, frames);
  if (interrupted) return kInterrupted;
  write_truth(folder, renderer.world());
  if (interrupted) return kInterrupted;
  folder.keep();
  std::cerr << options.output.string() << ": " << frames << (frames == 1 ? " picture" : " pictures")
            << " of each camera\n";
  return kDone;
}

}  // namespace svchain::program
