// What is asserted of every calibration that is accepted, on two simulated sets.

#include "usecases/svchain_accuracy/simulated_set.h"

#include "tests/catch.h"

using namespace svchain;

namespace {

/// Lengths in parts of a car's.
void check_within_limits(const accuracy::SimulatedSet& set, double scale) {
  const accuracy::SetResult result = accuracy::measure(set);
  INFO(text_of(result));
  CHECK(result.posed.accepted);
  CHECK(result.posed.worst.rotation_deg < 0.05);
  CHECK(result.posed.worst.translation_mm < 3 * scale);
  CHECK(result.posed.worst.ground_mm < 5 * scale);
  CHECK(result.posed.worst.sigmas < 5);
  CHECK(result.unposed.accepted);
  CHECK(result.unposed.worst.ground_mm < 5 * scale);
  CHECK(result.unposed.worst.sigmas < 5);
  CHECK(result.posed.worst.ground_mm < result.refined.ground_mm);
  CHECK(result.posed.worst.ground_mm < result.homography_ground_mm);
}

}  // namespace

TEST_CASE("a simulated car is calibrated within the limits, and better than in the plain ways") {
  check_within_limits({"car", "kannala_brandt", 101}, 1);
}

TEST_CASE("a simulated toy with another lens is calibrated within a tenth of the limits") {
  check_within_limits({"toy", "double_sphere", 102}, 0.1);
}
