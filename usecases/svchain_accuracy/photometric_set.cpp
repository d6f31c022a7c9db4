#include "usecases/svchain_accuracy/photometric_set.h"

#include <filesystem>
#include <stdexcept>

#include "algorithms/scene/hash.h"
#include "algorithms/scene/scene_file.h"
#include "algorithms/scene/still_renderer.h"
#include "algorithms/scene/top_view.h"

namespace svchain::accuracy {

const ResponseRange kLikeCameras = {"gains 0.85-1.2", {0.85, 1.2}, {1, 1}, {0, 0}, {0, 0}};
const ResponseRange kUnlikeCameras = {
    "gains 0.7-1.4, gammas 0.9-1.15, vignetting", {0.7, 1.4}, {0.9, 1.15}, {0.05, 0.15}, {0, 0.08}};

geometry::View photometric_view(const geometry::Vehicle& vehicle) {
  const Eigen::Vector2i size_px(880, 1080);
  return {size_px, geometry::default_metres_per_px(vehicle, size_px), {0, 0}};
}

scene::Scene photometric_scene(const ResponseRange& range, uint64_t seed) {
  const auto file = std::filesystem::path(SVCHAIN_SOURCE_DIR) / "configs" / "scenes" / "parking.json";
  auto read = scene::read_scene(file);
  if (!read) throw std::runtime_error(read.error().front().text());
  scene::Scene scene = *std::move(read);
  uint64_t count = 0;
  const auto draw = [&](const std::array<double, 2>& between) {
    const double share = scene::unit(scene::hash(seed, 0x70686f746full, count++));
    return between[0] + (between[1] - between[0]) * share;
  };
  for (auto& response : scene.responses) {
    for (double& gain : response.gain_bgr) gain = draw(range.gain);
    response.gamma = draw(range.gamma);
    response.falloff[0] = draw(range.falloff_1);
    response.falloff[1] = draw(range.falloff_2);
    response.noise_sigma = 2;
  }
  scene.path.travel_m = 0;
  scene.timestamp_jitter_ms = 0;
  scene.seed = seed;
  return scene;
}

PhotometricSet simulated_photometric_set(const ResponseRange& range, uint64_t seed) {
  const auto world = std::make_shared<const scene::World>(photometric_scene(range, seed));
  const scene::Scene& scene = world->scene();
  PhotometricSet set;
  set.name = range.name;
  set.rig = scene.rig;
  set.view = photometric_view(scene.rig.vehicle);
  const scene::StillRenderer renderer(world);
  for (size_t camera = 0; camera < set.rig.cameras.size(); ++camera)
    set.frames.push_back(renderer.render(camera, 0, 0));
  set.truth = {scene.responses, scene::ideal_top_view(*world, set.view, 0)};
  return set;
}

}  // namespace svchain::accuracy
