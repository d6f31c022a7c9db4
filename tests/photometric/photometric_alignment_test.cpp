#include "algorithms/photometric/photometric_alignment.h"

#include <cstring>

#include "algorithms/synthesis/fixed_point.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/photometric/made_statistics.h"

using namespace svchain;
using namespace svchain::photometric;
using namespace svchain::testing;

namespace {

AlignmentSettings settings(double smoothing = 0.02, bool falloff = false) {
  return {4, 1000, smoothing, falloff};
}

/// What correction makes of a place that a camera sees at the distance q from its lens's centre.
double corrected(const ToneCurves& curves, const MadeCamera& camera, int i, int channel, double light,
                 double q2) {
  const auto& [p1, p2] = curves.log_falloff[i];
  const double unfaded = camera.value(light, channel, q2) * std::exp(p1 * q2 + p2 * q2 * q2);
  const double log_value = std::log(std::min(255.0, unfaded));
  return std::exp(log_value + log_gain_at(curves.log_gain[i][channel], place_of(log_value)));
}

/// How far apart four cameras are after correction, relative, over the brightness that the statistics have.
double largest_disagreement(const ToneCurves& curves, const FourCameras& cameras, double q2 = 0,
                            double brightest = 180) {
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (double light = 40; light <= brightest; light += 20)
      for (int i = 1; i < 4; ++i)
        largest = std::max(largest, std::abs(corrected(curves, cameras[i], i, c, light, q2) /
                                                 corrected(curves, cameras[0], 0, c, light, q2) -
                                             1));
  return largest;
}

/// Of any entry of any curve.
int largest_change(const synthesis::ToneMapping& a, const synthesis::ToneMapping& b, size_t from = 0,
                   size_t to = 3) {
  int largest = 0;
  for (size_t i = from; i <= to; ++i)
    for (int c = 0; c < 3; ++c)
      for (int v = 0; v < 256; ++v)
        largest = std::max(largest, std::abs(a.curves[i][c][v] - b.curves[i][c][v]));
  return largest;
}

ToneCurves curves_from(MadeStatistics statistics, bool falloff = false) {
  PhotometricAlignment alignment(settings(0.02, falloff));
  alignment.update(*statistics);
  return alignment.curves();
}

}  // namespace

TEST_CASE("before the first frame every value stays as it is") {
  const auto identity = synthesis::ToneMapping::identity();
  CHECK(largest_change(PhotometricAlignment(settings()).tone_mapping(), identity) == 0);
}

TEST_CASE("cameras of unlike gains agree after one frame") {
  CHECK(largest_disagreement(ToneCurves{}, kUnlikeGains) > 0.3);
  CHECK(largest_disagreement(curves_from(ring_of_four(kUnlikeGains)), kUnlikeGains) < 0.02);
}

TEST_CASE("cameras of unlike gains and gammas agree after one frame") {
  CHECK(largest_disagreement(curves_from(ring_of_four(kUnlikeGammas)), kUnlikeGammas) < 0.03);
}

TEST_CASE("cameras agree although what they see of the ground differs by a few percent") {
  CHECK(largest_disagreement(curves_from(ring_of_four(kUnlikeGammas, 0.03)), kUnlikeGammas) < 0.05);
}

TEST_CASE("equal cameras keep their values within one level") {
  auto statistics = ring_of_four(kEqualCameras, 0.01);
  PhotometricAlignment alignment(settings(0.02, true));
  CHECK(largest_change(alignment.update(*statistics), synthesis::ToneMapping::identity()) <= 1);
}

TEST_CASE("the geometric mean of the four cameras' curves is the identity") {
  const ToneCurves curves = curves_from(ring_of_four(kUnlikeGammas, 0.03));
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < kKnots; ++k) {
      double sum = 0;
      for (int i = 0; i < 4; ++i) sum += curves.log_gain[i][c][k];
      CHECK(sum == Approx(0).margin(1e-4));
    }
}

TEST_CASE("noise does not flatten the curves") {
  // Noise on both sides makes every relation look flatter than it is: the way into the trivial solution.
  const ToneCurves curves = curves_from(ring_of_four(kUnlikeGains, 0.25));
  for (int c = 0; c < 3; ++c) {
    double contrast = 0;
    for (int i = 0; i < 4; ++i) contrast += curves.log_gain[i][c][3] - curves.log_gain[i][c][1];
    CHECK(std::abs(contrast / 4) < 0.01);
  }
}

TEST_CASE("a lens's falloff is found, together with gains and gammas") {
  FourCameras cameras = kUnlikeGammas;
  for (int i = 0; i < 4; ++i) cameras[i].falloff = 0.15 + 0.05 * i;
  const ToneCurves curves = curves_from(ring_of_four(cameras, 0.01), true);
  for (const double q2 : {0.2, 0.5, 0.8}) CHECK(largest_disagreement(curves, cameras, q2) < 0.04);
  for (int i = 0; i < 4; ++i) {
    const double rise =
        corrected(curves, cameras[i], i, 1, 100, 0.8) / corrected(curves, cameras[i], i, 1, 100, 0);
    CHECK(rise == Approx(1).margin(0.05));  // and would fall to 0.75 to 0.9 without
  }
}

TEST_CASE("without falloff in the pictures none is undone") {
  auto statistics = ring_of_four(kUnlikeGammas, 0.02);
  PhotometricAlignment alignment(settings(0.02, true));
  const auto& mapping = alignment.update(*statistics);
  for (int i = 0; i < 4; ++i) CHECK(!mapping.has_falloff(i));
}

TEST_CASE("blocks that do not show the same thing are left out, and counted") {
  auto statistics = ring_of_four(kUnlikeGains, 0.01);
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 12; ++i) {
      MadeCamera wrong = kUnlikeGains[a];
      wrong.gain[i % 3] *= i % 2 ? 0.5 : 0.4;  // one channel is enough, and always the same direction
      statistics.add(a, (a + 1) % 4, statistics.some_ground(), wrong, kUnlikeGains[(a + 1) % 4]);
    }
  PhotometricAlignment alignment(settings());
  alignment.update(*statistics);
  CHECK(largest_disagreement(alignment.curves(), kUnlikeGains) < 0.03);
  CHECK(alignment.rejections().contradicting >= 48);
  CHECK(alignment.blocks_used() > 150);
}

TEST_CASE("small and dark blocks are left out, and counted by reason") {
  auto statistics = ring_of_four(kUnlikeGains);
  statistics.add(0, 1, {}, {}, {}).pixels = 49;
  statistics.add(1, 2, {{3, 100, 100}, 0}, {}, {});
  statistics.add(1, 2, {{100, 100, 100}, 0}, {{0.1, 1, 1}}, {});
  statistics.add(0, 1, {}, {}, {}).camera_a = 9;
  PhotometricAlignment alignment(settings());
  alignment.update(*statistics);
  const Rejections rejections = alignment.rejections();
  CHECK(rejections.small == 1);
  CHECK(rejections.dark == 1);
  CHECK(rejections.contradicting == 1);
  CHECK(alignment.blocks_used() == 160);
}

TEST_CASE(
    "what one camera clips comes more than twice as near to what another sees as a gain would bring it") {
  FourCameras cameras = kEqualCameras;
  cameras[2].gain = {1.35, 1.35, 1.35};
  MadeStatistics statistics = ring_of_four(cameras);
  for (int i = 0; i < 20; ++i)
    for (const int a : {1, 2}) statistics.add(a, a + 1, {{215, 215, 215}, 0}, cameras[a], cameras[a + 1]);
  const ToneCurves curves = curves_from(std::move(statistics));
  for (int c = 0; c < 3; ++c)
    CHECK(corrected(curves, cameras[2], 2, c, 215, 0) ==
          Approx(corrected(curves, cameras[1], 1, c, 215, 0)).epsilon(0.05));  // 0.11 as a gain
}

TEST_CASE("a camera that is white or black keeps its curves and moves no other") {
  const auto gain = GENERATE(100.0, 0.01);
  PhotometricAlignment alignment(settings());
  auto before = ring_of_four(kUnlikeGains);
  alignment.update(*before);
  const auto mapping = alignment.tone_mapping();
  FourCameras cameras = kUnlikeGains;
  cameras[1].gain = {gain, gain, gain};
  auto after = ring_of_four(cameras);
  for (int frame = 0; frame < 50; ++frame) alignment.update(*after);
  CHECK(largest_change(alignment.tone_mapping(), mapping) <= 1);
  CHECK(alignment.blocks_used() == 80);
  const Rejections rejections = alignment.rejections();
  CHECK(rejections.saturated + rejections.dark + rejections.contradicting == 80);
}

TEST_CASE("overlaps that are not connected each keep their own level") {
  MadeStatistics statistics;
  for (int i = 0; i < 40; ++i)
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(2, 3)})
      statistics.add(a, b, statistics.some_ground(), kUnlikeGains[a], kUnlikeGains[b]);
  const ToneCurves curves = curves_from(std::move(statistics));
  for (int c = 0; c < 3; ++c) {
    CHECK(corrected(curves, kUnlikeGains[0], 0, c, 100, 0) ==
          Approx(corrected(curves, kUnlikeGains[1], 1, c, 100, 0)).epsilon(0.02));
    CHECK(corrected(curves, kUnlikeGains[2], 2, c, 100, 0) ==
          Approx(corrected(curves, kUnlikeGains[3], 3, c, 100, 0)).epsilon(0.02));
    CHECK(curves.log_gain[0][c][2] + curves.log_gain[1][c][2] == Approx(0).margin(0.02));
  }
}

TEST_CASE("without any usable block the last curves stay, and the frames are counted") {
  auto statistics = ring_of_four(kUnlikeGains);
  MadeStatistics nothing;
  PhotometricAlignment alignment(settings());
  const auto mapping = alignment.update(*statistics);
  for (int frame = 0; frame < 30; ++frame) alignment.update(*nothing);
  CHECK(largest_change(alignment.tone_mapping(), mapping) == 0);
  CHECK(alignment.blocks_used() == 0);
  CHECK(alignment.frames() == 31);
  CHECK(alignment.frames_held() == 30);
}

TEST_CASE("frames that tell nothing do not count as the first") {
  MadeStatistics nothing;
  auto statistics = ring_of_four(kUnlikeGains);
  PhotometricAlignment late(settings()), early(settings());
  late.update(*nothing);
  CHECK(largest_change(late.update(*statistics), early.update(*statistics)) == 0);
}

TEST_CASE("a camera that exposes anew is caught up with in 15 frames, and moves no other") {
  const double stops = GENERATE(-1.5, -0.7, 0.4);
  FourCameras cameras = kUnlikeGammas;
  auto before = ring_of_four(cameras, 0.01);
  PhotometricAlignment alignment(settings());
  for (int frame = 0; frame < 20; ++frame) alignment.update(*before);
  const auto mapping = alignment.tone_mapping();
  for (double& gain : cameras[1].gain) gain *= std::exp2(stops);
  auto after = ring_of_four(cameras, 0.01);
  for (int frame = 0; frame < 15; ++frame) alignment.update(*after);
  CHECK(largest_disagreement(alignment.curves(), cameras, 0, 140) < 0.05);
  CHECK(largest_change(alignment.tone_mapping(), mapping, 2, 3) <= 4);
  CHECK(largest_change(alignment.tone_mapping(), mapping, 0, 0) <= 4);
  for (int frame = 0; frame < 15; ++frame) {
    const ToneCurves last = alignment.curves();
    alignment.update(*after);
    for (int i = 0; i < 4; ++i)
      CHECK(std::abs(corrected(alignment.curves(), cameras[i], i, 1, 100, 0) -
                     corrected(last, cameras[i], i, 1, 100, 0)) < 0.3);
  }
}

TEST_CASE("something that covers a third of an overlap moves no curve by more than two levels") {
  auto before = ring_of_four(kUnlikeGammas, 0.01);
  PhotometricAlignment alignment(settings());
  for (int frame = 0; frame < 20; ++frame) alignment.update(*before);
  const auto mapping = alignment.tone_mapping();
  auto crossed = ring_of_four(kUnlikeGammas, 0.01);
  auto blocks = (*crossed).blocks();
  for (int i = 0; i < 13; ++i)
    for (int c = 0; c < 3; ++c) {
      auto& seen = const_cast<synthesis::OverlapBlock&>(blocks[i]).a;
      seen.sum[c] = seen.sum[c] / 3;
      seen.sum_of_squares[c] = seen.sum_of_squares[c] / 9;
    }
  for (int frame = 0; frame < 60; ++frame) CHECK(largest_change(alignment.update(*crossed), mapping) <= 2);
}

TEST_CASE("the common level comes back after cameras have changed, slowly") {
  FourCameras cameras = kEqualCameras;
  auto before = ring_of_four(cameras);
  PhotometricAlignment alignment(settings());
  alignment.update(*before);
  cameras[1].gain = {0.6, 0.6, 0.6};
  auto after = ring_of_four(cameras);
  const auto level = [&] {
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += alignment.curves().log_gain[i][1][2];
    return sum / 4;
  };
  for (int frame = 0; frame < 15; ++frame) alignment.update(*after);
  CHECK(level() > 0.1);
  for (int frame = 0; frame < 4000; ++frame) alignment.update(*after);
  CHECK(level() == Approx(0).margin(0.005));
}

TEST_CASE("the differences of the overlaps are told before and after") {
  auto statistics = ring_of_four(kUnlikeGammas, 0.005);
  PhotometricAlignment alignment(settings());
  alignment.update(*statistics);
  const auto overlaps = alignment.differences();
  REQUIRE(overlaps.size() == 4);
  for (const OverlapDifference& overlap : overlaps) {
    CHECK(overlap.camera_b == (overlap.camera_a + 1) % 4);
    CHECK(overlap.blocks == 40);
    CHECK(overlap.before > 5);
    CHECK(overlap.after < 1.5);
  }
}

TEST_CASE("the same frames give the same tone mapping, bit by bit") {
  auto statistics = ring_of_four(kUnlikeGammas, 0.05);
  PhotometricAlignment a(settings(0.02, true)), b(settings(0.02, true));
  for (int frame = 0; frame < 5; ++frame) {
    a.update(*statistics);
    b.update(*statistics);
  }
  CHECK(std::memcmp(&a.curves(), &b.curves(), sizeof(ToneCurves)) == 0);
}

TEST_CASE("an update allocates nothing") {
  auto statistics = ring_of_four(kUnlikeGammas, 0.05);
  PhotometricAlignment alignment(settings(0.02, true));
  const size_t before = allocation_count();
  for (int frame = 0; frame < 3; ++frame) alignment.update(*statistics);
  CHECK(allocation_count() == before);
}

TEST_CASE("statistics of more blocks than expected lose those that are too many") {
  auto statistics = ring_of_four(kUnlikeGains);
  PhotometricAlignment alignment({4, 100, 0.02, true});
  alignment.update(*statistics);
  CHECK(alignment.blocks_used() == 100);
}

TEST_CASE("numbers of cameras and smoothings out of range are refused") {
  CHECK_THROWS_AS(PhotometricAlignment({0, 10}), std::invalid_argument);
  CHECK_THROWS_AS(PhotometricAlignment({9, 10}), std::invalid_argument);
  CHECK_THROWS_AS(PhotometricAlignment({4, 10, 0}), std::invalid_argument);
  CHECK_THROWS_AS(PhotometricAlignment({4, 10, 1.5}), std::invalid_argument);
}
