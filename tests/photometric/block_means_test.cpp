#include "algorithms/photometric/block_means.h"

#include <opencv2/core.hpp>

#include "algorithms/synthesis/synthesize.h"
#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"

using namespace svchain;
using namespace svchain::photometric;
using namespace svchain::testing;

namespace {

const Eigen::Vector2i kImage(320, 180);

struct Fixture {
  geometry::Rig rig = four_cameras(kImage);
  geometry::View view = view_of(rig, {201, 243});
  OwnedLut owned{rig, view};
  std::vector<cv::Mat> frames;

  Fixture() {
    for (int i = 0; i < 4; ++i) {
      frames.emplace_back(kImage.y(), kImage.x(), CV_8UC3);
      cv::RNG(static_cast<uint64_t>(i + 1)).fill(frames.back(), cv::RNG::UNIFORM, 0, 200);
    }
  }
};

}  // namespace

TEST_CASE("without correction, block means are those of synthesis' statistics") {
  Fixture f;
  std::vector<std::byte> memory(synthesis::OverlapStatistics::bytes_for(f.view));
  auto* statistics = synthesis::OverlapStatistics::create(memory);
  cv::Mat out(243, 201, CV_8UC3);
  const auto identity = synthesis::ToneMapping::identity();
  synthesis::synthesize(f.owned.lut(), f.frames, identity, out, statistics);
  const auto means = block_means(f.owned.lut(), f.frames, identity);
  REQUIRE(means.size() == statistics->count);
  for (size_t i = 0; i < means.size(); ++i) {
    const auto& block = statistics->blocks()[i];
    REQUIRE(means[i].block == block.block);
    CHECK(means[i].camera_a == block.camera_a);
    CHECK(means[i].camera_b == block.camera_b);
    CHECK(means[i].pixels == int(block.pixels));
    for (int c = 0; c < 3; ++c) {
      CHECK(means[i].a[c] == Approx(double(block.a.sum[c]) / block.pixels));
      CHECK(means[i].b[c] == Approx(double(block.b.sum[c]) / block.pixels));
    }
  }
}

TEST_CASE("block means are of what falloff and curves make of the pixels") {
  Fixture f;
  for (auto& frame : f.frames) frame.setTo(cv::Scalar(100, 100, 100));
  auto mapping = synthesis::ToneMapping::identity();
  mapping.curves[1][0].fill(7);
  mapping.falloff[2] = {4096, 0};
  for (const BlockMeans& block : block_means(f.owned.lut(), f.frames, mapping)) {
    if (block.camera_a == 1) CHECK(block.a[0] == 7);
    if (block.camera_b == 1) CHECK(block.b[0] == 7);
    if (block.camera_a == 2) CHECK(block.a[1] > 101);
    if (block.camera_a == 3) CHECK(block.a[1] == 100);
    CHECK(block.difference() ==
          Approx((std::abs(block.a[0] - block.b[0]) + std::abs(block.a[1] - block.b[1]) +
                  std::abs(block.a[2] - block.b[2])) /
                 3));
  }
}

TEST_CASE("frames that do not fit the LUT are refused") {
  Fixture f;
  const auto identity = synthesis::ToneMapping::identity();
  CHECK_THROWS_AS(block_means(f.owned.lut(), std::span(f.frames).first(3), identity), std::invalid_argument);
  f.frames[2] = cv::Mat(10, 10, CV_8UC3);
  CHECK_THROWS_AS(block_means(f.owned.lut(), f.frames, identity), std::invalid_argument);
}
