// `kannala_brandt`, `polynomial`, `eucm` and `double_sphere` in rig files.

#include <nlohmann/json.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/double_sphere.h"
#include "algorithms/geometry/eucm.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/lens_models.h"
#include "algorithms/geometry/polynomial.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

constexpr const char* kTurns = "the image height stops rising";

}  // namespace

LensPtr read_kannala_brandt(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "focal_px", "centre_px", "k", "max_angle_deg"});
  const auto focal_px = pair(lens.required("focal_px"), kFocalPx);
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const auto k = lens.required("k").numbers(4, kCoefficient);
  const double widest = max_angle_rad(lens);
  if (lens.fault_count() > before) return nullptr;
  return within_its_limit(
      std::make_shared<KannalaBrandt>(focal_px, centre_px, std::array{k[0], k[1], k[2], k[3]}, widest), lens,
      kTurns);
}

ordered_json write_kannala_brandt(const Lens& lens) {
  const auto& made = dynamic_cast<const KannalaBrandt&>(lens);
  return {{"model", made.model()},
          {"focal_px", pair(made.focal_px())},
          {"centre_px", pair(made.centre_px())},
          {"k", made.k()},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

LensPtr read_polynomial(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "focal_px", "centre_px", "k", "max_angle_deg"});
  constexpr json::Range kAspect{0.1, 10};
  const auto scale = lens.required("focal_px");
  const auto items = scale.items(2);
  const Eigen::Vector2d focal_px(1, items.empty() ? 1 : items[1].number(kAspect));
  if (!items.empty() && items[0].number() != 1)
    items[0].fault("expected 1: focal_px is [1, aspect] here, k is in px");
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const auto k = lens.required("k").numbers(4, kCoefficient);
  const double widest = max_angle_rad(lens);
  if (lens.fault_count() > before) return nullptr;
  const PolynomialCurve curve{{k[0], k[1], k[2], k[3]}};
  return within_its_limit(std::make_shared<Polynomial>(curve, focal_px, centre_px, widest), lens, kTurns);
}

ordered_json write_polynomial(const Lens& lens) {
  const auto& made = dynamic_cast<const Polynomial&>(lens);
  return {{"model", made.model()},
          {"focal_px", pair(made.focal_px())},
          {"centre_px", pair(made.centre_px())},
          {"k", made.curve().k_px},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

LensPtr read_eucm(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "alpha", "beta", "focal_px", "centre_px", "max_angle_deg"});
  const EucmCurve curve{lens.required("alpha").number(kShare), lens.required("beta").number(kBeta)};
  const auto focal_px = pair(lens.required("focal_px"), kFocalPx);
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const double widest = max_angle_rad(lens);
  if (lens.fault_count() > before) return nullptr;
  return within_its_limit(std::make_shared<Eucm>(curve, focal_px, centre_px, widest), lens, kTurns);
}

ordered_json write_eucm(const Lens& lens) {
  const auto& made = dynamic_cast<const Eucm&>(lens);
  return {{"model", made.model()},
          {"alpha", made.curve().alpha},
          {"beta", made.curve().beta},
          {"focal_px", pair(made.focal_px())},
          {"centre_px", pair(made.centre_px())},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

LensPtr read_double_sphere(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "xi", "alpha", "focal_px", "centre_px", "max_angle_deg"});
  const DoubleSphereCurve curve{lens.required("xi").number(kSphereShift),
                                lens.required("alpha").number(kShare)};
  const auto focal_px = pair(lens.required("focal_px"), kFocalPx);
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const double widest = max_angle_rad(lens);
  if (lens.fault_count() > before) return nullptr;
  return within_its_limit(std::make_shared<DoubleSphere>(curve, focal_px, centre_px, widest), lens, kTurns);
}

ordered_json write_double_sphere(const Lens& lens) {
  const auto& made = dynamic_cast<const DoubleSphere&>(lens);
  return {{"model", made.model()},
          {"xi", made.curve().xi},
          {"alpha", made.curve().alpha},
          {"focal_px", pair(made.focal_px())},
          {"centre_px", pair(made.centre_px())},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

}  // namespace svchain::geometry
