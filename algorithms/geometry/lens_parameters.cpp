#include "algorithms/geometry/lens_parameters.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/double_sphere.h"
#include "algorithms/geometry/eucm.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/mei.h"
#include "algorithms/geometry/ocam.h"
#include "algorithms/geometry/pinhole.h"
#include "algorithms/geometry/polynomial.h"
#include "algorithms/geometry/table_lens.h"

namespace svchain::geometry {

namespace {

using Numbers = std::vector<double>;

/// A parameter and what rig files take for it.
struct Parameter {
  std::string name;
  json::Range range;
};
using Parameters = std::vector<Parameter>;

Parameters operator+(Parameters a, const Parameters& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Parameters kFocal = {{"focal_px.x", kFocalPx}, {"focal_px.y", kFocalPx}};
const Parameters kCentre = {{"centre_px.x", kCentrePx}, {"centre_px.y", kCentrePx}};

Parameters coefficients(const std::vector<std::string>& names) {
  Parameters list;
  for (const auto& name : names) list.push_back({name, kCoefficient});
  return list;
}

template <size_t kSize>
Numbers numbers(Numbers before, const Eigen::Vector2d& focal_px, const Eigen::Vector2d& centre_px,
                const std::array<double, kSize>& k) {
  before.insert(before.end(), {focal_px.x(), focal_px.y(), centre_px.x(), centre_px.y()});
  before.insert(before.end(), k.begin(), k.end());
  return before;
}

Numbers of_kannala_brandt(const Lens& lens) {
  const auto& made = dynamic_cast<const KannalaBrandt&>(lens);
  return numbers({}, made.focal_px(), made.centre_px(), made.k());
}

LensPtr make_kannala_brandt(const Lens& lens, const Numbers& p) {
  return std::make_shared<KannalaBrandt>(Eigen::Vector2d(p[0], p[1]), Eigen::Vector2d(p[2], p[3]),
                                         std::array{p[4], p[5], p[6], p[7]}, lens.max_angle_rad());
}

Numbers of_polynomial(const Lens& lens) {
  const auto& made = dynamic_cast<const Polynomial&>(lens);
  const auto& k = made.curve().k_px;
  return {k[0], k[1], k[2], k[3], made.focal_px().y(), made.centre_px().x(), made.centre_px().y()};
}

LensPtr make_polynomial(const Lens& lens, const Numbers& p) {
  return std::make_shared<Polynomial>(PolynomialCurve{{p[0], p[1], p[2], p[3]}}, Eigen::Vector2d(1, p[4]),
                                      Eigen::Vector2d(p[5], p[6]), lens.max_angle_rad());
}

Numbers of_table(const Lens& lens) {
  const auto& made = dynamic_cast<const TableLens&>(lens);
  return {made.pixel_um(), made.centre_px().x(), made.centre_px().y()};
}

LensPtr make_table(const Lens& lens, const Numbers& p) {
  const auto& made = dynamic_cast<const TableLens&>(lens);
  return std::make_shared<TableLens>(made.table(), p[0], Eigen::Vector2d(p[1], p[2]), lens.max_angle_rad());
}

Numbers of_ocam(const Lens& lens) {
  const auto& made = dynamic_cast<const Ocam&>(lens);
  const auto& centre = made.centre_row_column();
  return {made.inverse_polynomial().front(), made.affine()[0], made.affine()[2], centre.y(), centre.x()};
}

LensPtr make_ocam(const Lens& lens, const Numbers& p) {
  const auto& made = dynamic_cast<const Ocam&>(lens);
  auto polynomial = made.inverse_polynomial();
  const double scale = p[0] / polynomial.front();
  for (double& coefficient : polynomial) coefficient *= scale;
  const Eigen::Vector3d affine(p[1], made.affine()[1], p[2]);
  constexpr double kLeastArea = 0.1;  // as in rig files
  if (!(affine[0] - affine[1] * affine[2] >= kLeastArea)) return nullptr;
  return std::make_shared<Ocam>(polynomial, affine, Eigen::Vector2d(p[4], p[3]), lens.max_angle_rad());
}

Numbers of_mei(const Lens& lens) {
  const auto& made = dynamic_cast<const Mei&>(lens);
  return numbers({made.xi()}, made.focal_px(), made.centre_px(), made.k());
}

LensPtr make_mei(const Lens& lens, const Numbers& p) {
  return std::make_shared<Mei>(p[0], Eigen::Vector2d(p[1], p[2]), Eigen::Vector2d(p[3], p[4]),
                               std::array{p[5], p[6], p[7], p[8]}, lens.max_angle_rad());
}

Numbers of_eucm(const Lens& lens) {
  const auto& made = dynamic_cast<const Eucm&>(lens);
  return numbers<0>({made.curve().alpha, made.curve().beta}, made.focal_px(), made.centre_px(), {});
}

LensPtr make_eucm(const Lens& lens, const Numbers& p) {
  return std::make_shared<Eucm>(EucmCurve{p[0], p[1]}, Eigen::Vector2d(p[2], p[3]),
                                Eigen::Vector2d(p[4], p[5]), lens.max_angle_rad());
}

Numbers of_double_sphere(const Lens& lens) {
  const auto& made = dynamic_cast<const DoubleSphere&>(lens);
  return numbers<0>({made.curve().xi, made.curve().alpha}, made.focal_px(), made.centre_px(), {});
}

LensPtr make_double_sphere(const Lens& lens, const Numbers& p) {
  return std::make_shared<DoubleSphere>(DoubleSphereCurve{p[0], p[1]}, Eigen::Vector2d(p[2], p[3]),
                                        Eigen::Vector2d(p[4], p[5]), lens.max_angle_rad());
}

Numbers of_pinhole(const Lens& lens) {
  const auto& made = dynamic_cast<const Pinhole&>(lens);
  return numbers({}, made.focal_px(), made.centre_px(), made.k());
}

LensPtr make_pinhole(const Lens& lens, const Numbers& p) {
  return std::make_shared<Pinhole>(Eigen::Vector2d(p[0], p[1]), Eigen::Vector2d(p[2], p[3]),
                                   std::array{p[4], p[5], p[6], p[7], p[8]}, lens.max_angle_rad());
}

/// Every lens model; a new one adds its two functions above and its line here.
struct Model {
  std::string name;
  Parameters parameters;
  Numbers (*numbers)(const Lens&);
  LensPtr (*make)(const Lens&, const Numbers&);
};

const Model& model_of(const Lens& lens) {
  constexpr json::Range kRadiusPx{1, 1e5}, kAffine{-10, 10}, kAspect{0.1, 10}, kPixelUm{0.1, 100};
  static const std::vector<Model> kModels = {
      {"kannala_brandt", kFocal + kCentre + coefficients({"k1", "k2", "k3", "k4"}), of_kannala_brandt,
       make_kannala_brandt},
      {"polynomial", coefficients({"k1", "k2", "k3", "k4"}) + Parameters{{"aspect", kAspect}} + kCentre,
       of_polynomial, make_polynomial},
      {"table", Parameters{{"pixel_um", kPixelUm}} + kCentre, of_table, make_table},
      {"ocam", Parameters{{"rho_90_px", kRadiusPx}, {"c", kAffine}, {"e", kAffine}} + kCentre, of_ocam,
       make_ocam},
      {"mei", Parameters{{"xi", kSphereShift}} + kFocal + kCentre + coefficients({"k1", "k2", "p1", "p2"}),
       of_mei, make_mei},
      {"eucm", Parameters{{"alpha", kShare}, {"beta", kBeta}} + kFocal + kCentre, of_eucm, make_eucm},
      {"double_sphere", Parameters{{"xi", kSphereShift}, {"alpha", kShare}} + kFocal + kCentre,
       of_double_sphere, make_double_sphere},
      {"pinhole", kFocal + kCentre + coefficients({"k1", "k2", "p1", "p2", "k3"}), of_pinhole, make_pinhole},
  };
  const std::string name = lens.model();
  for (const auto& model : kModels) {
    if (model.name == name) return model;
  }
  throw std::logic_error("lens model \"" + name + "\" has no line in lens_parameters.cpp");
}

/// Slope at `middle` between two neighbours a step away, of which one may be missing.
std::optional<Eigen::Vector2d> slope(const std::optional<Eigen::Vector2d>& after,
                                     const Eigen::Vector2d& middle,
                                     const std::optional<Eigen::Vector2d>& before, double step) {
  if (after && before) return Eigen::Vector2d((*after - *before) / (2 * step));
  if (after) return Eigen::Vector2d((*after - middle) / step);
  if (before) return Eigen::Vector2d((middle - *before) / step);
  return std::nullopt;
}

}  // namespace

std::vector<std::string> lens_parameter_names(const Lens& lens) {
  std::vector<std::string> names;
  for (const auto& parameter : model_of(lens).parameters) names.push_back(parameter.name);
  return names;
}

std::vector<double> lens_parameters(const Lens& lens) {
  return model_of(lens).numbers(lens);
}

LensPtr with_parameters(const Lens& lens, const std::vector<double>& parameters) {
  const Model& model = model_of(lens);
  if (parameters.size() != model.parameters.size()) return nullptr;
  for (size_t i = 0; i < parameters.size(); ++i) {
    if (!model.parameters[i].range.contains(parameters[i])) return nullptr;
  }
  constexpr double kLeastAngleRad = radians(1);  // as in rig files
  auto made = model.make(lens, parameters);
  return made && made->max_angle_rad() >= kLeastAngleRad ? made : nullptr;
}

std::optional<LensJacobian> project_with_jacobian(const Lens& lens, const Eigen::Vector3d& ray) {
  constexpr double kStep = 1e-5;
  const double length = ray.norm();
  const Eigen::Vector3d unit = ray / length;
  const auto pixel = lens.project(ray);
  if (!pixel) return std::nullopt;
  LensJacobian jacobian{*pixel, {}};
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
    const auto by_axis = slope(lens.project(unit + step), *pixel, lens.project(unit - step), kStep);
    if (!by_axis) return std::nullopt;
    jacobian.by_ray.col(axis) = *by_axis / length;
  }
  return jacobian;
}

LensVariations::LensVariations(const Lens& lens) : lens_(lens) {
  constexpr double kStep = 1e-6;
  const auto numbers = lens_parameters(lens);
  for (size_t i = 0; i < numbers.size(); ++i) {
    const double step = kStep * (1 + std::abs(numbers[i]));
    auto after = numbers, before = numbers;
    after[i] += step;
    before[i] -= step;
    steps_.push_back({step, with_parameters(lens, after), with_parameters(lens, before)});
  }
}

std::optional<Eigen::Matrix2Xd> LensVariations::by_parameters(const Eigen::Vector3d& ray) const {
  const auto pixel = lens_.project(ray);
  if (!pixel) return std::nullopt;
  const auto through = [&](const LensPtr& lens) -> std::optional<Eigen::Vector2d> {
    if (!lens) return std::nullopt;
    return lens->project(ray);
  };
  Eigen::Matrix2Xd jacobian(2, static_cast<Eigen::Index>(steps_.size()));
  for (size_t i = 0; i < steps_.size(); ++i) {
    const auto by = slope(through(steps_[i].after), *pixel, through(steps_[i].before), steps_[i].size);
    if (!by) return std::nullopt;
    jacobian.col(static_cast<Eigen::Index>(i)) = *by;
  }
  return jacobian;
}

}  // namespace svchain::geometry
