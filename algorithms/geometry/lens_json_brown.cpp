// `mei` and `pinhole` in rig files.

#include <nlohmann/json.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/lens_models.h"
#include "algorithms/geometry/mei.h"
#include "algorithms/geometry/pinhole.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

constexpr const char* kFolds = "the picture folds or runs away to infinity";

}  // namespace

LensPtr read_mei(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "xi", "focal_px", "centre_px", "k", "max_angle_deg"});
  const double xi = lens.required("xi").number(kSphereShift);
  const auto focal_px = pair(lens.required("focal_px"), kFocalPx);
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const auto k = lens.required("k").numbers(4, kCoefficient);
  const double widest = max_angle_rad(lens);
  if (lens.fault_count() > before) return nullptr;
  return within_its_limit(
      std::make_shared<Mei>(xi, focal_px, centre_px, std::array{k[0], k[1], k[2], k[3]}, widest), lens,
      kFolds);
}

ordered_json write_mei(const Lens& lens) {
  const auto& made = dynamic_cast<const Mei&>(lens);
  return {{"model", made.model()},
          {"xi", made.xi()},
          {"focal_px", pair(made.focal_px())},
          {"centre_px", pair(made.centre_px())},
          {"k", made.k()},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

LensPtr read_pinhole(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "focal_px", "centre_px", "k", "max_angle_deg"});
  const auto focal_px = pair(lens.required("focal_px"), kFocalPx);
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const auto k = lens.required("k").numbers(5, kCoefficient);
  const double widest = max_angle_rad(lens);
  if (lens.fault_count() > before) return nullptr;
  return within_its_limit(
      std::make_shared<Pinhole>(focal_px, centre_px, std::array{k[0], k[1], k[2], k[3], k[4]}, widest), lens,
      kFolds);
}

ordered_json write_pinhole(const Lens& lens) {
  const auto& made = dynamic_cast<const Pinhole&>(lens);
  return {{"model", made.model()},
          {"focal_px", pair(made.focal_px())},
          {"centre_px", pair(made.centre_px())},
          {"k", made.k()},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

}  // namespace svchain::geometry
