#include "tests/catch.h"
#include "usecases/svchain_accuracy/overlap_mean_gains.h"
#include "usecases/svchain_accuracy/photometric_figures.h"

using namespace svchain;
using namespace svchain::accuracy;

namespace {

/// Blocks of four cameras of which each has its own gain, on equal ground.
std::vector<synthesis::OverlapBlock> blocks_of(const std::array<double, 4>& gains) {
  std::vector<synthesis::OverlapBlock> blocks;
  for (int a = 0; a < 4; ++a) {
    synthesis::OverlapBlock block{};
    block.camera_a = static_cast<uint16_t>(a);
    block.camera_b = static_cast<uint16_t>((a + 1) % 4);
    block.pixels = 1600;
    block.a.sum.fill(static_cast<uint32_t>(160000 * gains[a]));
    block.b.sum.fill(static_cast<uint32_t>(160000 * gains[(a + 1) % 4]));
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace

TEST_CASE("the baseline's gains make equal what differs by gains, and keep their geometric mean") {
  const std::array<double, 4> gains = {0.8, 1.25, 1, 1};
  const auto mapping = overlap_mean_gains(blocks_of(gains));
  for (size_t i = 0; i < 4; ++i)
    for (size_t c = 0; c < 3; ++c) CHECK(mapping.curves[i][c][100] == Approx(100 / gains[i]).margin(0.5));
}

TEST_CASE("grey world makes the composite's channels equally bright") {
  const auto mapping = grey_world(synthesis::ToneMapping::identity(), {80, 100, 120});
  CHECK(mapping.curves[0][0][80] == 100);
  CHECK(mapping.curves[1][1][100] == 100);
  CHECK(mapping.curves[2][2][120] == 100);
}

TEST_CASE("unlike cameras agree better than after the baseline, on blocks that were left out") {
  const PhotometricSet set = simulated_photometric_set(kUnlikeCameras, 4);
  const auto figures = PhotometricMeasurement(set).measure_all();
  REQUIRE(figures.size() == 6);
  const auto& before = figures[0];
  const auto& baseline = figures[1];
  const auto& inverted = figures[2];
  const auto& without_falloff = figures[4];
  const auto& ours = figures[5];
  CHECK(before.left > 15);
  CHECK(baseline.left < before.left / 3);
  CHECK(without_falloff.left < 1.1 * inverted.left);
  CHECK(ours.left < 2);
  CHECK(*ours.from_ideal < 2);
  CHECK(ours.contrast > 0.85);
  for (size_t i = 0; i < 4; ++i) CHECK(ours.overlaps[i] < baseline.overlaps[i]);
}
