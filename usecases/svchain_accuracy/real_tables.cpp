#include "usecases/svchain_accuracy/real_tables.h"

#include "usecases/svchain_accuracy/reasons.h"

namespace svchain::accuracy {

Section absent(const std::string& title, const Faults& faults) {
  return {title, "Not measured: " + faults.front().text() + ".\n", {}};
}

std::string verdict(const calibration::Calibration& made) {
  return made.accepted() ? "accepted" : "**rejected** (" + reasons_of(made) + ")";
}

std::string how_it_ended(const HeldOutResult& result) {
  return "The calibration without even corners was " + verdict(result.made[0]) +
         ", the one without odd ones " + verdict(result.made[1]) + ". " +
         std::to_string(result.ours.rejected) +
         " held-out corners are outliers by our calibration and in nobody's figures.\n";
}

Table between_cameras(const HeldOutResult& result, const std::array<double, 4>& limits_cm) {
  Table table{{"same corner by two cameras", "corners", "cm RMS", "limit", "met", "its author, RMS",
               "its author, median"},
              {}};
  for (size_t c = 0; c < 4; ++c) {
    const double apart_cm = result.ours.pair_cm[c].rms();
    table.rows.push_back({geometry::kCameraNames[c] + "-" + geometry::kCameraNames[(c + 1) % 4],
                          std::to_string(result.ours.pair_cm[c].count()), figure(apart_cm),
                          figure(limits_cm[c]), met(apart_cm, limits_cm[c]),
                          figure(result.given.pair_cm[c].rms()), figure(result.given.pair_cm[c].median())});
  }
  return table;
}

}  // namespace svchain::accuracy
