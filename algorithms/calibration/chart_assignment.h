#pragma once
// Which chart every fragment is: by its pattern (identity.h), and where the pattern leaves a choice, by where
// it lies. Charts with a pose are the nearest ones to what the levelled cameras see. Those without are told
// apart by their patterns; equal ones are taken in the order of the file, clockwise around the vehicle from
// its left side on (left, front left, front, ... rear left). Pure.

#include <string>

#include "algorithms/calibration/identity.h"
#include "algorithms/calibration/levelling.h"

namespace svchain::calibration {

struct NamedCorner {
  size_t chart = 0;
  int corner = 0;
  Eigen::Vector2d pixel = {0, 0};
  Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Identity();
};

struct ChartAssignment {
  std::vector<std::vector<NamedCorner>> named;                     // by camera
  std::vector<std::optional<geometry::Pose2>> vehicle_from_chart;  // posed, or first guess; missing: not seen
  /// Fragments, by camera, that are a posed chart's by their pattern but lie elsewhere or turned.
  std::vector<int> contradictions = {};
};

/// How well a camera's pose was known before it was levelled.
struct PoseSigma {
  double rad = 0;
  double m = 0;
};

/// `reach_m`: how far a chart may seem to be from where it is.
ChartAssignment assign_charts(const std::vector<Levelled>& cameras, const std::vector<ChartPattern>& patterns,
                              const PoseSigma& sigma, double reach_m);

}  // namespace svchain::calibration
