#include "usecases/svchain_accuracy/trial.h"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "algorithms/calibration/scene_charts.h"
#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/scene/hash.h"
#include "algorithms/scene/nominal_rig.h"
#include "algorithms/scene/scene_file.h"
#include "algorithms/scene/still_renderer.h"
#include "usecases/svchain_accuracy/lens_like.h"

namespace svchain::accuracy {

namespace {

using geometry::radians;
using scene::Scene;

constexpr double kCarLengthM = 4.8;

/// Numbers drawn one after the other.
class Dice {
 public:
  explicit Dice(uint64_t seed) : seed_(scene::hash(seed, 0x747269616cull)) {}
  double between(double least, double most) {
    return least + (most - least) * scene::unit(scene::hash(seed_, count_++));
  }
  double within(double reach) { return between(-reach, reach); }
  Eigen::Vector3d vector_within(double reach) {
    const double x = within(reach), y = within(reach);
    return {x, y, within(reach)};
  }
  scene::Colour colour() {
    const auto level = [this] { return static_cast<uint8_t>(between(20, 235)); };
    const uint8_t b = level(), g = level();
    return {b, g, level()};
  }

 private:
  uint64_t seed_;
  uint64_t count_ = 0;
};

/// Poses as on another vehicle of the same make, lenses as of another batch.
void draw_rig(geometry::Rig& rig, const std::string& lens_model, double scale, Dice& dice) {
  for (auto& camera : rig.cameras) {
    const Eigen::Vector3d turn = dice.vector_within(radians(3));
    camera.vehicle_from_camera =
        turned_and_shifted(camera.vehicle_from_camera, turn, dice.vector_within(0.05 * scale));
    const auto& lens = dynamic_cast<const geometry::KannalaBrandt&>(*camera.lens);
    const Eigen::Vector2d focal_px = lens.focal_px() * dice.between(0.99, 1.01);
    const double right_px = dice.within(5), down_px = dice.within(5);
    const Eigen::Vector2d centre_px = lens.centre_px() + Eigen::Vector2d(right_px, down_px);
    camera.lens = lens_like(lens_model, geometry::KannalaBrandt(focal_px, centre_px, lens.k()));
  }
}

void draw_responses(Scene& scene, Dice& dice) {
  for (auto& response : scene.responses) {
    const double exposure = dice.between(0.7, 1.25);
    for (double& gain : response.gain_bgr) gain = exposure * dice.between(0.92, 1.08);
    response.gamma = dice.between(0.85, 1.15);
    response.falloff = {dice.between(0.05, 0.15), dice.between(0, 0.08)};
    response.noise_sigma = 2;
  }
}

void draw_charts(Scene& scene, double scale, Dice& dice) {
  for (auto& chart : scene.charts) {
    chart.world_from_chart.x_m += dice.within(0.1 * scale);
    chart.world_from_chart.y_m += dice.within(0.1 * scale);
    chart.world_from_chart.yaw_rad += radians(dice.within(8));
  }
}

/// Things that stand around beyond the charts, and paint beside the vehicle.
void draw_clutter(Scene& scene, double scale, Dice& dice) {
  const auto place = [&](double nearest_m, double farthest_m) {
    const double around = dice.within(std::numbers::pi);
    const double away_m = scale * dice.between(nearest_m, farthest_m);
    return geometry::Pose2{away_m * std::cos(around), away_m * std::sin(around), dice.within(3)};
  };
  for (int i = 0; i < 4; ++i) {
    const geometry::Pose2 pose = place(6.5, 10);
    const Eigen::Vector3d size_m(dice.between(0.4, 2), dice.between(0.4, 2), dice.between(0.3, 1.8));
    scene.boxes.push_back({pose, scale * size_m, dice.colour()});
  }
  for (int i = 0; i < 5; ++i) {
    const geometry::Pose2 pose = place(5.5, 9);
    const double radius_m = scale * dice.between(0.03, 0.15), height_m = scale * dice.between(0.5, 2.5);
    scene.posts.push_back({{pose.x_m, pose.y_m}, radius_m, height_m, dice.colour()});
  }
  for (int i = 0; i < 8; ++i) {
    const geometry::Pose2 pose = place(5, 8);
    const Eigen::Vector2d half = 0.5 * scale * Eigen::Vector2d(dice.between(0.2, 1), dice.between(0.2, 1));
    scene::Patch patch;
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      patch.corners_m.push_back(pose * Eigen::Vector2d(x * half.x(), y * half.y()));
    patch.colour = dice.colour();
    scene.paint.push_back(patch);
  }
}

}  // namespace

Scene trial_scene(const std::string& vehicle, const std::string& lens_model, uint64_t seed) {
  const auto folder = std::filesystem::path(SVCHAIN_SOURCE_DIR) / "configs" / "scenes";
  auto read = scene::read_scene(folder / (vehicle == "toy" ? "toy.json" : "parking.json"));
  if (!read) throw std::runtime_error(read.error().front().text());
  Scene scene = *std::move(read);
  const double scale = std::min(1.0, scene.rig.vehicle.length_m / kCarLengthM);
  Dice dice(seed);
  draw_rig(scene.rig, lens_model, scale, dice);
  draw_responses(scene, dice);
  draw_charts(scene, scale, dice);
  draw_clutter(scene, scale, dice);
  scene.path.travel_m = 0;
  scene.timestamp_jitter_ms = 0;
  scene.seed = seed;
  return scene;
}

std::vector<calibration::Chart> unposed(std::vector<calibration::Chart> charts) {
  for (auto& chart : charts) chart.vehicle_from_chart.reset();
  return charts;
}

calibration::CalibrationInput input_of(const Scene& scene) {
  calibration::CalibrationInput input;
  input.nominal = scene::nominal_rig(scene);
  input.charts = calibration::charts_of(scene);
  const scene::StillRenderer renderer(std::make_shared<const scene::World>(scene));
  for (size_t camera = 0; camera < scene.rig.cameras.size(); ++camera)
    input.pictures.push_back(renderer.render(camera, 0, 0));
  return input;
}

}  // namespace svchain::accuracy
