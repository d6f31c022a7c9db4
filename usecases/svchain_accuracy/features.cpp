// Alignment from features: from poses off as a measuring tape leaves them, and from the pictures' content.

#include <algorithm>
#include <optional>
#include <random>

#include "algorithms/calibration/accuracy.h"
#include "algorithms/calibration/content_start.h"
#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/ray_from_ground.h"
#include "algorithms/registration/alignment.h"
#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/real_sets.h"
#include "usecases/svchain_accuracy/real_tables.h"
#include "usecases/svchain_accuracy/trial.h"

namespace svchain::accuracy {

namespace {

using calibration::CalibrationInput;
using geometry::Rig;

constexpr unsigned kSeeds = 10;

struct Set {
  std::string name;
  Result<CalibrationInput> input;
  std::array<double, 4> limits_px;
  double stretch;  // how far lenses may be wrong: registration::Uncertainty
};

struct HeldOut {
  int aligned = 0;
  int tried = 0;
  std::array<double, 4> worst_px = {0, 0, 0, 0};
  double slowest_ms = 0;
};

/// Every camera moved by up to 5 cm (of a car) and turned by up to 3 degrees about each axis.
Rig disturbed(Rig rig, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> within(-1, 1);
  const auto error = [&] { return Eigen::Vector3d(within(random), within(random), within(random)); };
  const double scale = calibration::scale_of(rig.vehicle);
  for (auto& camera : rig.cameras) {
    const Eigen::Vector3d turn_rad = geometry::radians(3) * error();
    camera.vehicle_from_camera =
        geometry::turned_and_shifted(camera.vehicle_from_camera, turn_rad, 0.05 * scale * error());
  }
  return rig;
}

void align(const Set& set, const Rig& start, double rotation_deg, double position_m, HeldOut& held_out) {
  constexpr double kEvenToSigma = 0.58;
  registration::AlignmentTask task;
  std::copy(set.input->pictures.begin(), set.input->pictures.end(), task.frames.begin());
  task.vehicle = start.vehicle;
  task.view.metres_per_px = 0.01 * calibration::scale_of(start.vehicle);
  task.start = {kEvenToSigma * geometry::radians(rotation_deg),
                kEvenToSigma * calibration::scale_of(start.vehicle) * position_m, set.stretch};
  for (size_t c = 0; c < task.cameras.size(); ++c) {
    const auto& camera = start.cameras[c];
    task.cameras[c] = {camera.lens, camera.image_size_px,
                       geometry::ray_from_ground(camera.vehicle_from_camera)};
  }
  ++held_out.tried;
  const auto aligned = registration::align(task);
  if (!aligned) return;
  ++held_out.aligned;
  double ms = 0;
  for (const auto& stage : aligned->times) ms += stage.ms;
  held_out.slowest_ms = std::max(held_out.slowest_ms, ms);
  for (size_t a = 0; a < 4; ++a)
    held_out.worst_px[a] = std::max(held_out.worst_px[a], aligned->overlaps[a].held_out_rms_px());
}

HeldOut from_tape(const Set& set) {
  HeldOut held_out;
  for (unsigned seed = 1; seed <= kSeeds; ++seed)
    align(set, disturbed(set.input->nominal, seed), 3, 0.05, held_out);
  return held_out;
}

/// The poses of the rig are not looked at.
HeldOut from_content(const Set& set) {
  CalibrationInput input = *set.input;
  input.charts = unposed(input.charts);
  calibration::start_from_content(input);
  HeldOut held_out;
  align(set, calibration::calibrate(input).rig, 1, 0.03, held_out);
  return held_out;
}

std::vector<std::string> row(const Set& set, const std::string& start, const HeldOut& held_out) {
  std::vector<std::string> cells = {
      set.name, start, std::to_string(held_out.aligned) + " of " + std::to_string(held_out.tried)};
  bool within = held_out.aligned > 0;
  for (size_t a = 0; a < 4; ++a) {
    cells.push_back(figure(held_out.worst_px[a]) + " (" + figure(set.limits_px[a]) + ")");
    within = within && held_out.worst_px[a] <= set.limits_px[a];
  }
  cells.push_back(within ? "yes" : "**no**");
  cells.push_back(figure(held_out.slowest_ms));
  return cells;
}

CalibrationInput simulated(const std::string& vehicle) {
  return input_of(trial_scene(vehicle, "kannala_brandt", 1));
}

}  // namespace

Section features(const std::filesystem::path& data) {
  constexpr std::array<double, 4> kSimulatedPx = {0.5, 0.5, 0.5, 0.5};
  const std::vector<Set> sets = {
      {"simulated car", simulated("car"), kSimulatedPx, 1e-4},
      {"simulated toy", simulated("toy"), kSimulatedPx, 1e-4},
      {"real carpet", read_carpet(data), {2, 2, 3.5, 2}, 0.01},
      {"real garage", read_garage(data), {2, 2, 2, 2}, 0.01},
  };
  Table table{
      {"set", "start", "aligned", "front-right", "right-rear", "rear-left", "left-front", "met", "ms"}, {}};
  for (const auto& set : sets) {
    if (!set.input) continue;
    table.rows.push_back(row(set, "off by up to 5 cm, 3 degrees", from_tape(set)));
    table.rows.push_back(row(set, "the pictures' content", from_content(set)));
  }
  return {
      "Alignment from features",
      "Four perspective matrices from features of the overlaps alone (`algorithms/registration`); charts are "
      "not told from other paint. Distance of features that were left out of the fit, in px of 1 cm (toy: 1 "
      "mm), RMS, the worst of " +
          std::to_string(kSeeds) +
          " starts; limits in brackets. Starts: the rig's poses, every camera off by up to 5 cm (toy: 5 mm) "
          "along and 3 degrees about each axis; or no poses at all, but what the pictures show of charts "
          "whose "
          "places nobody knows. The slowest run, on one core. Sets whose data are absent are left out.",
      {table}};
}

}  // namespace svchain::accuracy
