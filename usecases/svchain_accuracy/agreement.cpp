#include "usecases/svchain_accuracy/agreement.h"

#include <algorithm>
#include <optional>

#include "algorithms/calibration/levelling.h"

namespace svchain::accuracy {

namespace {

using calibration::Calibration;
using calibration::CornerRecord;
using calibration::CornerState;
using calibration::HoldOut;
using Eigen::Vector2d;
using geometry::Rig;

constexpr double kCmPerM = 100;

bool is_held_out(const CornerRecord& record, HoldOut hold_out) {
  return record.state != CornerState::kNotFound && record.corner % 2 == (hold_out == HoldOut::kOdd ? 1 : 0);
}

std::optional<Vector2d> ground_of(const Rig& rig, const CornerRecord& record) {
  const auto& camera = rig.cameras[record.camera];
  return calibration::ground_of(*camera.lens, camera.vehicle_from_camera, record.found_px);
}

void add_against_chart(const CornerRecord& record, const calibration::Chart& chart, const Rig& rig,
                       Agreement& agreement) {
  if (!chart.vehicle_from_chart) return;
  const auto& camera = rig.cameras[record.camera];
  const Vector2d place =
      *chart.vehicle_from_chart * calibration::corners(chart)[static_cast<size_t>(record.corner)].place_m;
  const auto ground = ground_of(rig, record);
  if (!ground) return;
  const Vector2d sight = (place - camera.vehicle_from_camera.translation.head<2>()).normalized();
  const Vector2d off_cm = kCmPerM * (*ground - place);
  agreement.ground_cm[record.camera].add(off_cm.norm());
  agreement.across_cm[record.camera].add(off_cm.dot(Vector2d(-sight.y(), sight.x())));
}

}  // namespace

double Errors::rms() const {
  double sum = 0;
  for (const double size : sizes_) sum += size * size;
  return sizes_.empty() ? 0 : std::sqrt(sum / count());
}

double Errors::median() const {
  if (sizes_.empty()) return 0;
  std::vector<double> sizes = sizes_;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

void add_held_out(const Calibration& made, const Rig& rig, HoldOut hold_out, Agreement& agreement) {
  std::vector<CornerRecord> corners;
  for (const auto& record : made.corners) {
    if (!is_held_out(record, hold_out)) continue;
    if (record.state == CornerState::kRejected)
      ++agreement.rejected;
    else
      corners.push_back(record);
  }
  for (const auto& one : corners) {
    add_against_chart(one, made.charts[one.chart], rig, agreement);
    for (const auto& other : corners) {
      if (other.camera != (one.camera + 1) % 4 || other.chart != one.chart || other.corner != one.corner)
        continue;
      const auto here = ground_of(rig, one), there = ground_of(rig, other);
      if (here && there) agreement.pair_cm[one.camera].add(kCmPerM * (*here - *there).norm());
    }
  }
}

HeldOutResult hold_out_in_turn(calibration::CalibrationInput input) {
  HeldOutResult result;
  for (const HoldOut half : {HoldOut::kEven, HoldOut::kOdd}) {
    input.hold_out = half;
    const Calibration& made = result.made[half == HoldOut::kOdd] = calibrate(input);
    add_held_out(made, made.rig, half, result.ours);
    add_held_out(made, input.nominal, half, result.given);
  }
  return result;
}

}  // namespace svchain::accuracy
