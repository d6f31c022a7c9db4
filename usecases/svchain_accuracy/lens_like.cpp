#include "usecases/svchain_accuracy/lens_like.h"

#include <Eigen/QR>
#include <cmath>
#include <stdexcept>

#include "algorithms/geometry/double_sphere.h"
#include "algorithms/geometry/eucm.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/lens_parameters.h"
#include "algorithms/geometry/levenberg_marquardt.h"
#include "algorithms/geometry/mei.h"
#include "algorithms/geometry/ocam.h"
#include "algorithms/geometry/pinhole.h"
#include "algorithms/geometry/polynomial.h"
#include "algorithms/geometry/table_lens.h"

namespace svchain::accuracy {

namespace {

using namespace geometry;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kWidestDeg = 90;

/// A lens's parameters, fitted so that it sees a fan of rays where another lens sees them.
class LensFit {
 public:
  explicit LensFit(const Lens& target) {
    for (int degree = 2; degree <= kWidestDeg; degree += 4) {
      for (int turn = 0; turn < 8; ++turn) {
        const double t = radians(degree), around = radians(45 * turn);
        rays_.push_back({std::sin(t) * std::cos(around), std::sin(t) * std::sin(around), std::cos(t)});
        pixels_.push_back(target.project(rays_.back()).value());
      }
    }
  }

  Eigen::VectorXd residuals(const LensPtr& lens) const {
    Eigen::VectorXd off(2 * static_cast<Eigen::Index>(rays_.size()));
    for (size_t i = 0; i < rays_.size(); ++i) {
      const auto pixel = lens ? lens->project(rays_[i]) : std::nullopt;
      off.segment<2>(2 * static_cast<Eigen::Index>(i)) =
          pixel ? Vector2d(*pixel - pixels_[i]) : Vector2d(Vector2d::Constant(kLostPx));
    }
    return off;
  }

  Eigen::MatrixXd jacobian(const LensPtr& lens) const {
    const LensVariations variations(*lens);
    const auto unknowns = static_cast<Eigen::Index>(lens_parameters(*lens).size());
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(rays_.size()), unknowns);
    for (size_t i = 0; i < rays_.size(); ++i) {
      if (const auto rows = variations.by_parameters(rays_[i]))
        j.middleRows<2>(2 * static_cast<Eigen::Index>(i)) = *rows;
    }
    return j;
  }

  LensPtr moved(const LensPtr& lens, const Eigen::VectorXd& step) const {
    std::vector<double> parameters = lens_parameters(*lens);
    for (size_t i = 0; i < parameters.size(); ++i) parameters[i] += step[static_cast<Eigen::Index>(i)];
    return with_parameters(*lens, parameters);
  }

 private:
  static constexpr double kLostPx = 1000;
  std::vector<Vector3d> rays_;
  std::vector<Vector2d> pixels_;
};

LensPtr table_like(const KannalaBrandt& target) {
  constexpr double kPixelUm = 4.2;
  LensTable table;
  for (int tenths = 1; tenths <= 950; ++tenths) {
    const double angle_deg = 0.1 * tenths;
    const double height_mm =
        1e-3 * kPixelUm * target.focal_px().x() * target.curve().radius(radians(angle_deg));
    table.angle_deg.push_back(angle_deg);
    table.height_mm.push_back(std::round(1e4 * height_mm) / 1e4);
  }
  return std::make_shared<TableLens>(table, kPixelUm, target.centre_px());
}

LensPtr ocam_like(const KannalaBrandt& target) {
  constexpr int kDegree = 7;
  Eigen::MatrixXd powers(96, kDegree + 1);
  Eigen::VectorXd rho(96);
  for (int degree = 0; degree <= 95; ++degree) {
    for (int power = 0; power <= kDegree; ++power)
      powers(degree, power) = std::pow(radians(degree - 90), power);
    rho[degree] = target.focal_px().x() * target.curve().radius(radians(degree));
  }
  const Eigen::VectorXd fitted = powers.colPivHouseholderQr().solve(rho);
  return std::make_shared<Ocam>(std::vector<double>(fitted.begin(), fitted.end()), Vector3d(1, 0, 0),
                                Vector2d(target.centre_px().y(), target.centre_px().x()));
}

/// Where the fit of a model starts.
LensPtr start_of(const std::string& model, const KannalaBrandt& target) {
  const Vector2d focal = target.focal_px(), centre = target.centre_px();
  if (model == "polynomial")
    return std::make_shared<Polynomial>(PolynomialCurve{{focal.x(), 0, 0, 0}}, Vector2d(1, 1), centre);
  if (model == "mei") return std::make_shared<Mei>(1.4, 2.4 * focal, centre, std::array{0., 0., 0., 0.});
  if (model == "eucm") return std::make_shared<Eucm>(EucmCurve{0.6, 1.05}, focal, centre, kUsualMaxAngleRad);
  if (model == "double_sphere")
    return std::make_shared<DoubleSphere>(DoubleSphereCurve{-0.1, 0.6}, focal, centre);
  throw std::invalid_argument("no lens model: " + model);
}

}  // namespace

LensPtr lens_like(const std::string& model, const Lens& target) {
  const auto& known = dynamic_cast<const KannalaBrandt&>(target);
  if (model == "kannala_brandt") return std::make_shared<KannalaBrandt>(known);
  if (model == "table") return table_like(known);
  if (model == "ocam") return ocam_like(known);
  if (model == "pinhole")
    return std::make_shared<Pinhole>(0.75 * known.focal_px(), known.centre_px(),
                                     std::array{-0.02, 0., 0., 0., 0.});
  return least_squares(LensFit(known), start_of(model, known), 1e-6);
}

}  // namespace svchain::accuracy
