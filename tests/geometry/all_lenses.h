#pragma once
// The lenses that every suite about lenses goes through: each model, plain and at its limits.

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/geometry/double_sphere.h"
#include "algorithms/geometry/eucm.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/mei.h"
#include "algorithms/geometry/ocam.h"
#include "algorithms/geometry/pinhole.h"
#include "algorithms/geometry/polynomial.h"
#include "algorithms/geometry/table_lens.h"
#include "tests/catch.h"

namespace svchain::testing {

using namespace geometry;

inline constexpr double kPi = 3.14159265358979323846;

/// A table as makers print them, of an equidistant lens with a little compression towards the rim.
inline LensTable printed_table(double last_deg, double printed_to_mm) {
  LensTable table;
  for (int tenths = 1; tenths <= 10 * last_deg; ++tenths) {
    const double angle_deg = 0.1 * tenths;
    const double t = radians(angle_deg);
    const double height = 1.3 * (t - 0.06 * t * t * t);
    table.angle_deg.push_back(angle_deg);
    table.height_mm.push_back(std::round(height / printed_to_mm) * printed_to_mm);
  }
  return table;
}

/// rho = 320 (th + pi/2) px: an equidistant lens in the words of OCamCalib.
inline const std::vector<double> kOcamEquidistant = {320 * kPi / 2, 320};

struct NamedLens {
  std::string name;
  LensPtr lens;
  bool keeps_direction = true;  // around the axis; tangential distortion does not
};

inline std::vector<NamedLens> all_lenses() {
  const Eigen::Vector2d centre(640.3, 359.1);
  return {
      {"kannala_brandt, equidistant",
       std::make_shared<KannalaBrandt>(Eigen::Vector2d(330, 330), centre, std::array{0., 0., 0., 0.})},
      {"kannala_brandt, anamorphic",
       std::make_shared<KannalaBrandt>(Eigen::Vector2d(302, 320), centre,
                                       std::array{-0.0437, 0.0217, -0.0264, 0.0084})},
      {"kannala_brandt, turning at 87 degrees",
       std::make_shared<KannalaBrandt>(Eigen::Vector2d(303, 322), centre,
                                       std::array{-0.0355, -0.0198, 0.0261, -0.0097})},
      {"kannala_brandt, 250 degrees wide",
       std::make_shared<KannalaBrandt>(Eigen::Vector2d(200, 200), centre, std::array{-0.01, 0., 0., 0.},
                                       radians(125))},
      {"table, exact", std::make_shared<TableLens>(printed_table(100, 1e-9), 4.2, centre)},
      {"table, printed to 0.01 mm", std::make_shared<TableLens>(printed_table(100, 1e-2), 4.2, centre)},
      {"table, ending at 60 degrees", std::make_shared<TableLens>(printed_table(60, 1e-3), 4.2, centre)},
      {"polynomial, as WoodScape's",
       std::make_shared<Polynomial>(PolynomialCurve{{339.749, -31.988, 48.275, -7.201}},
                                    Eigen::Vector2d(1, 1.02), centre)},
      {"polynomial, turning at 1 rad",
       std::make_shared<Polynomial>(PolynomialCurve{{300, -150, 0, 0}}, Eigen::Vector2d(1, 1), centre)},
      {"ocam", std::make_shared<Ocam>(kOcamEquidistant, Eigen::Vector3d(1.001, 0.002, -0.003),
                                      Eigen::Vector2d(359.1, 640.3))},
      {"ocam, 220 degrees wide", std::make_shared<Ocam>(kOcamEquidistant, Eigen::Vector3d(1, 0, 0),
                                                        Eigen::Vector2d(359.1, 640.3), radians(110))},
      {"mei", std::make_shared<Mei>(1.4, Eigen::Vector2d(700, 710), centre, std::array{-0.2, 0.05, 0., 0.})},
      {"mei, tangential, beyond its turning",
       std::make_shared<Mei>(1.4, Eigen::Vector2d(700, 710), centre, std::array{-0.02, 0.005, 2e-3, -1e-3},
                             radians(180)),
       false},
      {"mei, nearly a pinhole",
       std::make_shared<Mei>(0.1, Eigen::Vector2d(300, 310), centre, std::array{0., 0., 0., 0.})},
      {"eucm",
       std::make_shared<Eucm>(EucmCurve{0.61, 1.07}, Eigen::Vector2d(340, 342), centre, radians(110))},
      {"eucm, alpha below a half",
       std::make_shared<Eucm>(EucmCurve{0.2, 0.9}, Eigen::Vector2d(340, 342), centre)},
      {"double_sphere",
       std::make_shared<DoubleSphere>(DoubleSphereCurve{-0.18, 0.59}, Eigen::Vector2d(340, 342), centre)},
      {"double_sphere, beyond its turning",
       std::make_shared<DoubleSphere>(DoubleSphereCurve{0.3, 0.7}, Eigen::Vector2d(340, 342), centre,
                                      radians(180))},
      {"pinhole",
       std::make_shared<Pinhole>(Eigen::Vector2d(300, 310), centre, std::array{0., 0., 0., 0., 0.})},
      {"pinhole, barrel",
       std::make_shared<Pinhole>(Eigen::Vector2d(300, 310), centre, std::array{-0.3, 0.1, 0., 0., -0.012})},
      {"pinhole, tangential",
       std::make_shared<Pinhole>(Eigen::Vector2d(300, 310), centre, std::array{-0.05, 0.004, 1e-3, -2e-3, 0.},
                                 radians(60)),
       false},
  };
}

inline Eigen::Vector3d ray(double angle, double azimuth) {
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

inline void for_all_lenses(const std::function<void(const Lens&)>& check) {
  for (const auto& named : all_lenses()) {
    INFO(named.name);
    check(*named.lens);
  }
}

/// Rays from the axis to the very rim, all around.
inline void for_all_rays(const Lens& lens, const std::function<void(const Eigen::Vector3d&)>& check) {
  for (int i = 0; i <= 100; ++i) {
    for (int j = 0; j < 16; ++j) check(ray(lens.max_angle_rad() * i / 100, 2 * kPi * j / 16));
  }
}

}  // namespace svchain::testing
