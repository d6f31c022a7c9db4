#include "algorithms/photometric/gains.h"

#include "algorithms/photometric/histogram_median.h"
#include "tests/catch.h"
#include "tests/photometric/made_statistics.h"

using namespace svchain;
using namespace svchain::photometric;
using namespace svchain::testing;

namespace {

/// Largest relative error of the gains, which should make all responses equal and leave their common level.
double largest_error(const Gains& gains, const std::array<Response, 4>& responses) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    double level = 1;
    for (const Response& response : responses) level *= std::pow(response[c], 0.25);
    for (int i = 0; i < 4; ++i)
      largest = std::max(largest, std::abs(gains.value[i][c] * responses[i][c] / level - 1));
  }
  return largest;
}

double geometric_mean(const Gains& gains, int channel, int cameras = 4) {
  double product = 1;
  for (int i = 0; i < cameras; ++i) product *= gains.value[i][channel];
  return std::pow(product, 1.0 / cameras);
}

}  // namespace

TEST_CASE("known gains are recovered") {
  auto statistics = ring_of_four(kFourResponses);
  const Gains gains = estimate_gains(*statistics, 4);
  CHECK(largest_error(gains, kFourResponses) < 1e-4);
  CHECK(gains.blocks_used == 160);
  CHECK(gains.blocks_rejected == 0);
}

TEST_CASE("known gains are recovered from noisy blocks") {
  auto statistics = ring_of_four(kFourResponses, 0.02);
  const Gains gains = estimate_gains(*statistics, 4);
  CHECK(largest_error(gains, kFourResponses) < 0.01);
  CHECK(gains.blocks_used > 140);
}

TEST_CASE("equal cameras keep gains of one") {
  auto statistics = ring_of_four({Response{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  const Gains gains = estimate_gains(*statistics, 4);
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c) CHECK(gains.value[i][c] == Approx(1).epsilon(1e-9));
}

TEST_CASE("the common level stays") {
  auto statistics = ring_of_four(kFourResponses, 0.05);
  const Gains gains = estimate_gains(*statistics, 4);
  for (int c = 0; c < 3; ++c) CHECK(geometric_mean(gains, c) == Approx(1).epsilon(1e-9));
}

TEST_CASE("an estimate does not depend on the last one, except for the common level") {
  auto statistics = ring_of_four(kFourResponses, 0.02);
  Gains last = Gains::identity();
  last.value[1] = {2, 1, 0.5};
  const Gains fresh = estimate_gains(*statistics, 4), next = estimate_gains(*statistics, 4, last);
  for (int c = 0; c < 3; ++c) {
    CHECK(geometric_mean(next, c) == Approx(geometric_mean(last, c)).epsilon(1e-9));
    for (int i = 0; i < 4; ++i)
      CHECK(next.value[i][c] / next.value[0][c] ==
            Approx(fresh.value[i][c] / fresh.value[0][c]).epsilon(1e-5));
  }
}

TEST_CASE("blocks that do not show the same thing are left out") {
  auto statistics = ring_of_four(kFourResponses, 0.01);
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 12; ++i) {
      Response wrong = kFourResponses[a];
      wrong[i % 3] *= i % 2 ? 1.8 : 2.5;  // one channel is enough, and always the same direction
      statistics.add(a, (a + 1) % 4, statistics.some_ground(), wrong, kFourResponses[(a + 1) % 4]);
    }
  const Gains gains = estimate_gains(*statistics, 4);
  CHECK(largest_error(gains, kFourResponses) < 0.01);
  CHECK(gains.blocks_rejected >= 48);
  CHECK(gains.blocks_used > 130);
}

TEST_CASE("what the overlaps contradict each other by, all around the vehicle, is shared among them") {
  MadeStatistics statistics;
  const double excess = 1.2;
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 40; ++i)
      statistics.add(a, (a + 1) % 4, {100, 100, 100},
                     a == 3 ? Response{excess, excess, excess} : Response{1, 1, 1}, {1, 1, 1});
  const Gains gains = estimate_gains(*statistics, 4);
  CHECK(gains.blocks_used == 160);
  for (int a = 0; a < 4; ++a) {
    const double ratio = gains.value[a][0] / gains.value[(a + 1) % 4][0] * (a == 3 ? excess : 1);
    CHECK(ratio == Approx(std::pow(excess, 0.25)).epsilon(0.01));
  }
}

TEST_CASE("clipped, dark and tiny blocks are left out") {
  auto statistics = ring_of_four(kFourResponses);
  const auto add_with = [&](auto change) {
    statistics.add(0, 1, {100, 100, 100}, {1.5, 1.5, 1.5}, {1, 1, 1});
    const auto blocks = (*statistics).blocks();
    change(const_cast<synthesis::OverlapBlock&>(blocks.back()));
  };
  add_with([](auto& block) { block.a.clipped[2] = 200; });
  add_with([](auto& block) { block.b.clipped[0] = 200; });
  add_with([](auto& block) { block.b.sum = {1600, 1600, 1600}; });
  add_with([](auto& block) { block.pixels = 5; });
  add_with([](auto& block) { block.camera_a = 9; });
  const Gains gains = estimate_gains(*statistics, 4);
  CHECK(gains.blocks_rejected == 5);
  CHECK(largest_error(gains, kFourResponses) < 1e-4);
}

TEST_CASE("a camera without a usable overlap keeps its gain, and the others agree among themselves") {
  MadeStatistics statistics;
  for (int i = 0; i < 40; ++i)
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(3, 0)})
      statistics.add(a, b, statistics.some_ground(), kFourResponses[a], kFourResponses[b]);
  Gains last = Gains::identity();
  last.value[2] = {1.25, 0.75, 1.5};
  const Gains gains = estimate_gains(*statistics, 4, last);
  for (int c = 0; c < 3; ++c) {
    CHECK(gains.value[2][c] == Approx(last.value[2][c]).epsilon(1e-9));
    const auto corrected = [&](int i) { return gains.value[i][c] * kFourResponses[i][c]; };
    CHECK(corrected(1) == Approx(corrected(0)).epsilon(1e-4));
    CHECK(corrected(3) == Approx(corrected(0)).epsilon(1e-4));
  }
}

TEST_CASE("overlaps that are not connected each keep their own level") {
  MadeStatistics statistics;
  for (int i = 0; i < 40; ++i)
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(2, 3)})
      statistics.add(a, b, statistics.some_ground(), kFourResponses[a], kFourResponses[b]);
  const Gains gains = estimate_gains(*statistics, 4);
  for (int c = 0; c < 3; ++c) {
    CHECK(gains.value[0][c] * gains.value[1][c] == Approx(1).epsilon(1e-6));
    CHECK(gains.value[2][c] * gains.value[3][c] == Approx(1).epsilon(1e-6));
    CHECK(gains.value[2][c] / gains.value[3][c] ==
          Approx(kFourResponses[3][c] / kFourResponses[2][c]).epsilon(1e-4));
  }
}

TEST_CASE("without any usable block the last gains stay") {
  MadeStatistics nothing;
  Gains last = Gains::identity();
  last.value[1] = {1.5, 1.25, 0.5};
  const Gains gains = estimate_gains(*nothing, 4, last);
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c) CHECK(gains.value[i][c] == Approx(last.value[i][c]));
  CHECK(gains.blocks_used == 0);
}

TEST_CASE("tone curves are the rounded products, never falling and never above 255") {
  Gains gains = Gains::identity();
  gains.value[0] = {0.5, 1.3, 1.0};
  const auto mapping = tone_mapping(gains);
  CHECK(mapping.curves[0][0][255] == 128);
  CHECK(mapping.curves[0][0][100] == 50);
  CHECK(mapping.curves[0][1][100] == 130);
  CHECK(mapping.curves[0][1][197] == 255);
  CHECK(mapping.curves[0][2] == synthesis::ToneMapping::identity().curves[0][2]);
  for (const auto& camera : mapping.curves)
    for (const auto& curve : camera) CHECK(std::is_sorted(curve.begin(), curve.end()));
}

TEST_CASE("a histogram's median is that of its values, to half a bin") {
  HistogramMedian median(-2, 2);
  CHECK(median.median() == -2);
  for (const double v : {0.3, -1.5, 0.7, 0.31, 100.0}) median.add(v);
  CHECK(median.median() == Approx(0.31).margin(0.0005));
}
