// `ocam` in rig files.

#include <cmath>
#include <nlohmann/json.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/lens_models.h"
#include "algorithms/geometry/ocam.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

constexpr json::Range kOcamCoefficient{-1e9, 1e9};
constexpr size_t kMostCoefficients = 32;

std::vector<double> read_coefficients(const json::Value& list) {
  std::vector<double> coefficients;
  const auto items = list.items();
  for (const auto& item : items) coefficients.push_back(item.number(kOcamCoefficient));
  if (items.size() < 2 || items.size() > kMostCoefficients) {
    list.fault("expected 2 to 32 numbers, got " + std::to_string(items.size()));
  }
  return coefficients;
}

}  // namespace

LensPtr read_ocam(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "inverse_polynomial", "affine", "centre_px", "max_angle_deg"});
  const auto list = lens.required("inverse_polynomial");
  const auto coefficients = read_coefficients(list);
  const auto affine_value = lens.required("affine");
  const auto affine = affine_value.numbers(3, {-10, 10});
  const auto centre = pair(lens.required("centre_px"), kCentrePx);
  const double widest = max_angle_rad(lens);
  constexpr double kLeastArea = 0.1;
  if (lens.fault_count() == before && !(affine[0] - affine[1] * affine[2] >= kLeastArea)) {
    affine_value.fault("expected c, d, e with c - d e of at least 0.1 (it is about 1)");
  }
  if (lens.fault_count() > before) return nullptr;
  const auto made =
      std::make_shared<Ocam>(coefficients, Eigen::Vector3d(affine[0], affine[1], affine[2]), centre, widest);
  constexpr double kMostOnAxisPx = 10;
  if (const double on_axis_px = made->radius_px(0); !(std::abs(on_axis_px) <= kMostOnAxisPx)) {
    list.fault("expected about 0 px on the axis, where theta is -90 degrees, got " +
               ordered_json(on_axis_px).dump() + " (the constant comes first)");
    return nullptr;
  }
  return within_its_limit(made, lens, "the image height stops rising");
}

ordered_json write_ocam(const Lens& lens) {
  const auto& made = dynamic_cast<const Ocam&>(lens);
  const auto& affine = made.affine();
  return {{"model", made.model()},
          {"inverse_polynomial", made.inverse_polynomial()},
          {"affine", {affine[0], affine[1], affine[2]}},
          {"centre_px", pair(made.centre_row_column())},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

}  // namespace svchain::geometry
