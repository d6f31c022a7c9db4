#include "algorithms/photometric/tone_curves.h"

#include <algorithm>
#include <cmath>

#include "algorithms/synthesis/fixed_point.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::photometric;

TEST_CASE("curves that change nothing are the identity") {
  const auto mapping = tone_mapping(ToneCurves{}, 4);
  const auto identity = synthesis::ToneMapping::identity();
  CHECK(mapping.curves == identity.curves);
  CHECK(mapping.falloff == identity.falloff);
}

TEST_CASE("equal knots are a gain, rounded and at most 255") {
  ToneCurves curves;
  curves.log_gain[1][2].fill(std::log(1.3));
  const auto curve = tone_mapping(curves, 4).curves[1][2];
  CHECK(curve[0] == 0);
  CHECK(curve[1] == 1);
  CHECK(curve[100] == 130);
  CHECK(curve[196] == 255);
  CHECK(curve[255] == 255);
}

TEST_CASE("knots along a line of the logarithm are a gamma, from the darkest value to the brightest") {
  ToneCurves curves;
  for (int k = 0; k < kKnots; ++k) curves.log_gain[0][0][k] = -0.2 * std::log(kKnotLevels[k] / 255);
  const auto curve = tone_mapping(curves, 4).curves[0][0];
  for (int v = 1; v < 256; ++v) CHECK(curve[v] == Approx(255 * std::pow(v / 255.0, 0.8)).margin(0.51));
}

TEST_CASE("curves never fall, however the knots lie") {
  ToneCurves curves;
  curves.log_gain[0][0] = {1, -1, 1, -1, 1, -1.3};
  const auto curve = tone_mapping(curves, 4).curves[0][0];
  CHECK(std::is_sorted(curve.begin(), curve.end()));
}

TEST_CASE("falloff becomes a polynomial of q squared, to half a percent") {
  ToneCurves curves;
  curves.log_falloff[3] = {0.2, 0.1};
  const auto [a1, a2] = tone_mapping(curves, 4).falloff[3];
  for (double q2 = 0; q2 <= 1.2; q2 += 0.1)
    CHECK(1 + (a1 * q2 + a2 * q2 * q2) / synthesis::kRadialOne ==
          Approx(std::exp(0.2 * q2 + 0.1 * q2 * q2)).epsilon(0.005));
}

TEST_CASE("falloff below one percent is none, so that synthesis need not undo it") {
  ToneCurves curves;
  curves.log_falloff[3] = {0.005, 0.001};
  CHECK(!tone_mapping(curves, 4).has_falloff(3));
}

TEST_CASE("cameras that are not there keep their values") {
  ToneCurves curves;
  for (auto& camera : curves.log_gain) camera[0].fill(0.3);
  const auto mapping = tone_mapping(curves, 2);
  CHECK(mapping.curves[1][0][100] == 135);
  CHECK(mapping.curves[2] == synthesis::ToneMapping::identity().curves[2]);
}
