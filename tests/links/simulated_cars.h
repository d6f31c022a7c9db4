#pragma once
// The scenes that come with the program as their four cameras see them at the start, and geometric alignment
// alone on such pictures.

#include <array>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "algorithms/geometry/view.h"
#include "algorithms/scene/scene.h"
#include "framework/testing/harness.h"

namespace svchain::testing {

struct SimulatedCar {
  explicit SimulatedCar(const std::string& name);

  std::string input;  // "simulated:NAME"
  scene::Scene scene;
  std::array<cv::Mat, 4> pictures;
};

/// Made once.
const SimulatedCar& parking_car();
const SimulatedCar& toy_car();

struct AlignmentAlone : LinkHarness {
  enum class Rig { kUnwanted, kWanted };
  /// With a view of 440 x 540 px, and an output "rig" that is connected or not.
  AlignmentAlone(const SimulatedCar& car, const std::string& source, Rig rig = Rig::kUnwanted);

  void push_pictures();
  void push_black();
  geometry::View view() const;

 private:
  void push_set(const std::array<cv::Mat, 4>& pictures);

  const SimulatedCar& car_;
  uint64_t pushed_ = 0;
};

/// How far a LUT is from the truth, RMS over the pixels of the composite, by the true rig.
struct LutErrors {
  double place_m = 0;  // between the ground that a pixel shows and the one it stands for
  double blend_m = 0;  // between the two grounds that a blend shows
};

LutErrors errors_of(std::span<const std::byte> lut, const geometry::Rig& truth, const geometry::View& view);

}  // namespace svchain::testing
