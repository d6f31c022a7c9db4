#include <algorithm>

#include "usecases/svchain_accuracy/agreement.h"
#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/real_sets.h"
#include "usecases/svchain_accuracy/real_tables.h"

namespace svchain::accuracy {

namespace {

constexpr std::array<double, 4> kPairLimitCm = {1.6, 1.6, 3.3, 1.3};
constexpr std::array<double, 4> kGridLimitCm = {1.7, 1.7, 1.5, 2.3};
constexpr std::array<double, 4> kAcrossLimitCm = {0.7, 0.7, 0.7, 0.7};

Table against_chart(const std::string& what, const std::array<Errors, 4>& ours,
                    const std::array<Errors, 4>& given, const std::array<double, 4>& limits_cm) {
  Table table{{what, "corners", "cm RMS", "limit", "met", "its author, RMS", "its author, median"}, {}};
  for (size_t c = 0; c < 4; ++c) {
    table.rows.push_back({geometry::kCameraNames[c], std::to_string(ours[c].count()), figure(ours[c].rms()),
                          figure(limits_cm[c]), met(ours[c].rms(), limits_cm[c]), figure(given[c].rms()),
                          figure(given[c].median())});
  }
  return table;
}

}  // namespace

Section real_carpet(const std::filesystem::path& data) {
  const std::string title = "A real car on a carpet";
  const auto input = read_carpet(data);
  if (!input) return absent(title, input.error());
  const HeldOutResult result = hold_out_in_turn(*input);
  return {title,
          "Set `real_car_carpet`: a car with four 960x640 fisheyes on a printed carpet of 40 cm squares "
          "(`configs/charts/car_carpet.json`), outdoors. The calibration starts from the one that came with "
          "the pictures. It is fitted on one half of the corners and measured on the other, then the halves "
          "change roles; the figures are over both. \"Its author\" is the calibration that came with the "
          "pictures, on the same corners. The carpet has folds, which no calibration can explain; the "
          "author's RMS is large where his lens no longer fits the picture's rim. " +
              how_it_ended(result),
          {between_cameras(result, kPairLimitCm),
           against_chart("40 cm grid", result.ours.ground_cm, result.given.ground_cm, kGridLimitCm),
           against_chart("of it across the line of sight", result.ours.across_cm, result.given.across_cm,
                         kAcrossLimitCm)}};
}

}  // namespace svchain::accuracy
