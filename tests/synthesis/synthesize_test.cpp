#include "algorithms/synthesis/synthesize.h"

#include <map>
#include <opencv2/core.hpp>
#include <random>

#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"
#include "tests/synthesis/random_tone_mapping.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;

namespace {

const Eigen::Vector2i kImage(320, 180);

/// Statistics with the memory they live in.
class OwnedStatistics {
 public:
  explicit OwnedStatistics(const geometry::View& view)
      : memory_(OverlapStatistics::bytes_for(view)), statistics_(OverlapStatistics::create(memory_)) {}
  OverlapStatistics& operator*() { return *statistics_; }
  OverlapStatistics* get() { return statistics_; }

 private:
  std::vector<std::byte> memory_;
  OverlapStatistics* statistics_;
};

cv::Mat random_frame(uint64_t seed) {
  cv::Mat frame(kImage.y(), kImage.x(), CV_8UC3);
  cv::RNG(seed).fill(frame, cv::RNG::UNIFORM, 0, 256);
  return frame;
}

std::vector<cv::Mat> random_frames() {
  return {random_frame(1), random_frame(2), random_frame(3), random_frame(4)};
}

/// The four neighbours of a tap and their weights in 1024ths, as the definition of synthesis has them.
int defined_sample(const cv::Mat& frame, const DecodedTap& tap, int channel) {
  const auto at = [&](int dx, int dy) { return int{frame.at<cv::Vec3b>(tap.y + dy, tap.x + dx)[channel]}; };
  const int sum = at(0, 0) * (32 - tap.fx) * (32 - tap.fy) + at(1, 0) * tap.fx * (32 - tap.fy) +
                  at(0, 1) * (32 - tap.fx) * tap.fy + at(1, 1) * tap.fx * tap.fy;
  return (sum + 512) / 1024;
}

double plain_sample(const cv::Mat& frame, const DecodedTap& tap, int channel) {
  const auto at = [&](int dx, int dy) {
    return double(frame.at<cv::Vec3b>(tap.y + dy, tap.x + dx)[channel]);
  };
  const double fx = tap.fx / 32.0, fy = tap.fy / 32.0;
  return (at(0, 0) * (1 - fx) + at(1, 0) * fx) * (1 - fy) + (at(0, 1) * (1 - fx) + at(1, 1) * fx) * fy;
}

/// Calls f(column, row, channel, value) for what each byte of the composite should be.
template <class F>
void for_each_defined_value(const DecodedLut& lut, const std::vector<cv::Mat>& frames,
                            const ToneMapping& mapping, F f) {
  for (int row = 0; row < lut.height; ++row)
    for (int column = 0; column < lut.width; ++column)
      for (int c = 0; c < 3; ++c) {
        const DecodedPixel& pixel = lut.at(column, row);
        int value = pixel.background[c];
        int mapped[2] = {};
        for (int i = 0; i < pixel.tap_count(); ++i)
          mapped[i] = mapping.curves[pixel.taps[i].camera][c]
                                    [defined_sample(frames[pixel.taps[i].camera], pixel.taps[i], c)];
        if (pixel.kind == RegionKind::kCamera) value = mapped[0];
        if (pixel.kind == RegionKind::kBlend)
          value = static_cast<int>(
              std::lround((mapped[0] * pixel.weight + mapped[1] * (255 - pixel.weight)) / 255.0));
        f(column, row, c, value);
      }
}

size_t differing_bytes(const DecodedLut& lut, const std::vector<cv::Mat>& frames, const ToneMapping& mapping,
                       const cv::Mat& out) {
  size_t differing = 0;
  for_each_defined_value(lut, frames, mapping, [&](int column, int row, int c, int value) {
    differing += out.at<cv::Vec3b>(row, column)[c] != value;
  });
  return differing;
}

struct Fixture {
  geometry::Rig rig = four_cameras(kImage);
  geometry::View view = view_of(rig, {201, 243});
  OwnedLut owned{rig, view};
  GeometricLut lut = owned.lut();
  DecodedLut decoded = decode(lut);
  std::vector<cv::Mat> frames = random_frames();
  cv::Mat out{243, 201, CV_8UC3, cv::Scalar(7, 7, 7)};
  OwnedStatistics statistics{view};
};

}  // namespace

TEST_CASE("bilinear sampling rounds the exact mean, halves upwards") {
  for (const uint32_t fx : {0u, 1u, 16u, 31u})
    for (const uint32_t fy : {0u, 7u, 16u, 31u})
      for (const uint32_t p : {0u, 1u, 127u, 255u}) {
        const double a = fx / 32.0, b = fy / 32.0, q = 255 - p;
        const double mean = (p * (1 - a) + q * a) * (1 - b) + (q * (1 - a) + p * a) * b;
        CHECK(bilinear(p, 255 - p, 255 - p, p, fx, fy) == std::floor(mean + 0.5));
      }
}

TEST_CASE("blending is rounded exactly for every pair of values and every weight") {
  size_t wrong = 0;
  for (uint32_t a = 0; a < 256; ++a)
    for (uint32_t b = 0; b < 256; ++b)
      for (uint32_t weight = 0; weight < 256; ++weight)
        wrong += blend(a, b, weight) != (2 * (a * weight + b * (255 - weight)) + 255) / 510;
  CHECK(wrong == 0);
}

TEST_CASE("the composite is what the definition says, byte by byte") {
  Fixture f;
  const ToneMapping mapping = random_tone_mapping();
  synthesize(f.lut, f.frames, mapping, f.out, nullptr);
  CHECK(differing_bytes(f.decoded, f.frames, mapping, f.out) == 0);
  synthesize(f.lut, f.frames, mapping, f.out, f.statistics.get());
  CHECK(differing_bytes(f.decoded, f.frames, mapping, f.out) == 0);
}

TEST_CASE("the composite is within a level of unrounded arithmetic") {
  Fixture f;
  synthesize(f.lut, f.frames, ToneMapping::identity(), f.out, nullptr);
  double largest = 0;
  for (int row = 0; row < f.decoded.height; ++row)
    for (int column = 0; column < f.decoded.width; ++column)
      for (int c = 0; c < 3; ++c) {
        const DecodedPixel& pixel = f.decoded.at(column, row);
        if (pixel.tap_count() == 0) continue;
        double value = plain_sample(f.frames[pixel.taps[0].camera], pixel.taps[0], c);
        if (pixel.tap_count() == 2)
          value = (value * pixel.weight +
                   plain_sample(f.frames[pixel.taps[1].camera], pixel.taps[1], c) * (255 - pixel.weight)) /
                  255;
        largest = std::max(largest, std::abs(value - f.out.at<cv::Vec3b>(row, column)[c]));
      }
  CHECK(largest <= 1);
}

TEST_CASE("falloff multiplies samples by 1 + a1 q^2 + a2 q^4 before the curve, to a level") {
  Fixture f;
  ToneMapping mapping = ToneMapping::identity();
  mapping.falloff[0] = {1229, -410};
  mapping.falloff[2] = {-820, 2048};
  synthesize(f.lut, f.frames, mapping, f.out, nullptr);
  size_t compared = 0, exact = 0;
  for (int row = 0; row < f.decoded.height; ++row)
    for (int column = 0; column < f.decoded.width; ++column) {
      const DecodedPixel& pixel = f.decoded.at(column, row);
      if (pixel.kind != RegionKind::kCamera) continue;
      const DecodedTap& tap = pixel.taps[0];
      const Eigen::Vector2d centre = (kImage.cast<double>().array() - 1) / 2;
      const double q2 = (Eigen::Vector2d(tap.px(), tap.py()) - centre).squaredNorm() / (160.0 * 160.0);
      const auto [a1, a2] = mapping.falloff[tap.camera];
      const double factor = 1 + a1 / 4096.0 * q2 + a2 / 4096.0 * q2 * q2;
      for (int c = 0; c < 3; ++c) {
        const double value = std::min(255.0, defined_sample(f.frames[tap.camera], tap, c) * factor);
        const int got = f.out.at<cv::Vec3b>(row, column)[c];
        REQUIRE(std::abs(got - value) < 1);
        ++compared;
        exact += got == std::lround(value);
      }
    }
  CHECK(compared > 10000);
  CHECK(exact > 0.97 * compared);
}

TEST_CASE("the LUT tells where in their images two cameras see a block they share") {
  Fixture f;
  synthesize(f.lut, f.frames, ToneMapping::identity(), f.out, f.statistics.get());
  REQUIRE((*f.statistics).count > 20);
  for (const OverlapBlock& overlap : (*f.statistics).blocks()) {
    double a = 0, b = 0;
    int pixels = 0;
    for (const DecodedPixel& pixel : f.decoded.pixels) {
      if (pixel.kind != RegionKind::kBlend || pixel.block != overlap.block ||
          pixel.taps[0].camera != overlap.camera_a)
        continue;
      const Eigen::Vector2d centre = (kImage.cast<double>().array() - 1) / 2;
      const auto q2 = [&](const DecodedTap& tap) {
        return (Eigen::Vector2d(tap.px(), tap.py()) - centre).squaredNorm() / (160.0 * 160.0);
      };
      a += q2(pixel.taps[0]);
      b += q2(pixel.taps[1]);
      ++pixels;
    }
    CHECK(overlap.q2_a == Approx(a / pixels).margin(0.001));
    CHECK(overlap.q2_b == Approx(b / pixels).margin(0.001));
  }
}

TEST_CASE("frames and composite may lie in larger pictures, and nothing beside them is read or written") {
  Fixture f;
  synthesize(f.lut, f.frames, ToneMapping::identity(), f.out, nullptr);
  const cv::Rect inner(3, 2, kImage.x(), kImage.y());
  for (const int surroundings : {0, 255}) {
    std::vector<cv::Mat> frames;
    for (const cv::Mat& frame : f.frames) {
      const cv::Mat canvas(kImage.y() + 5, kImage.x() + 11, CV_8UC3, cv::Scalar::all(surroundings));
      frame.copyTo(canvas(inner));
      frames.push_back(canvas(inner));
    }
    cv::Mat canvas(243 + 4, 201 + 6, CV_8UC3, cv::Scalar(1, 2, 3));
    cv::Mat out = canvas(cv::Rect(2, 2, 201, 243));
    synthesize(f.lut, frames, ToneMapping::identity(), out, nullptr);
    CHECK(cv::norm(out, f.out, cv::NORM_INF) == 0);
    out.setTo(cv::Scalar(1, 2, 3));
    cv::Mat difference;
    cv::absdiff(canvas, cv::Scalar(1, 2, 3), difference);
    CHECK(cv::countNonZero(difference.reshape(1)) == 0);
  }
}

TEST_CASE("a missing camera is a black one") {
  Fixture f;
  std::vector<cv::Mat> black = f.frames;
  black[1] = cv::Mat::zeros(kImage.y(), kImage.x(), CV_8UC3);
  const ToneMapping mapping = random_tone_mapping();
  OwnedStatistics expected(f.view);
  cv::Mat reference = f.out.clone();
  synthesize(f.lut, black, mapping, reference, expected.get());
  f.frames[1].release();
  synthesize(f.lut, f.frames, mapping, f.out, f.statistics.get());
  CHECK(cv::norm(reference, f.out, cv::NORM_INF) == 0);
  REQUIRE((*f.statistics).count == (*expected).count);
  for (size_t i = 0; i < (*expected).count; ++i)
    CHECK((*f.statistics).blocks()[i].b.sum == (*expected).blocks()[i].b.sum);
}

TEST_CASE("statistics are the sums over all pixels that blend, block by block and pair by pair") {
  Fixture f;
  for (cv::Mat& frame : f.frames)  // some of it clipped
    frame.forEach<cv::Vec3b>([](cv::Vec3b& p, const int* at) {
      if (at[1] % 50 < 25) p = cv::Vec3b(at[0] % 5, 255 - at[0] % 5, p[2]);
    });
  synthesize(f.lut, f.frames, random_tone_mapping(), f.out, f.statistics.get());

  std::map<std::array<uint32_t, 3>, OverlapBlock> expected;
  for (const DecodedPixel& pixel : f.decoded.pixels) {
    if (pixel.kind != RegionKind::kBlend) continue;
    const auto a = static_cast<uint16_t>(pixel.taps[0].camera),
               b = static_cast<uint16_t>(pixel.taps[1].camera);
    OverlapBlock& block = expected[{pixel.block, a, b}];
    block.camera_a = a;
    block.camera_b = b;
    block.block = pixel.block;
    ++block.pixels;
    for (int i = 0; i < 2; ++i)
      for (int c = 0; c < 3; ++c) {
        const auto v =
            static_cast<uint32_t>(defined_sample(f.frames[pixel.taps[i].camera], pixel.taps[i], c));
        BlockSamples& samples = i == 0 ? block.a : block.b;
        samples.sum[c] += v;
        samples.sum_of_squares[c] += v * v;
        samples.clipped[c] += v <= 2 || v >= 253;
      }
  }
  REQUIRE((*f.statistics).count == expected.size());
  CHECK(f.lut.header().overlap_count == expected.size());
  uint32_t clipped = 0;
  for (const OverlapBlock& block : (*f.statistics).blocks()) {
    const auto found = expected.find({block.block, block.camera_a, block.camera_b});
    REQUIRE(found != expected.end());
    found->second.q2_a = block.q2_a;  // the LUT's, tested by themselves
    found->second.q2_b = block.q2_b;
    CHECK(std::memcmp(&found->second, &block, sizeof block) == 0);
    clipped += block.a.clipped[0] + block.b.clipped[1];
  }
  CHECK(clipped > 1000);
}

TEST_CASE("statistics of the frame before do not linger") {
  Fixture f;
  synthesize(f.lut, f.frames, ToneMapping::identity(), f.out, f.statistics.get());
  const uint32_t count = (*f.statistics).count;
  synthesize(f.lut, f.frames, ToneMapping::identity(), f.out, f.statistics.get());
  CHECK((*f.statistics).count == count);
}

TEST_CASE("the room for statistics suffices for a coarse view, where blocks have several pairs") {
  const auto rig = four_cameras(kImage);
  for (const Eigen::Vector2i& size : {Eigen::Vector2i(41, 39), {61, 75}}) {
    const auto view = view_of(rig, size);
    const OwnedLut owned(rig, view);
    OwnedStatistics statistics(view);
    cv::Mat out(size.y(), size.x(), CV_8UC3);
    synthesize(owned.lut(), random_frames(), ToneMapping::identity(), out, statistics.get());
    CHECK((*statistics).count > block_count(size));
    CHECK((*statistics).count <= (*statistics).capacity);
  }
}

TEST_CASE("synthesis allocates nothing") {
  Fixture f;
  const ToneMapping mapping = ToneMapping::identity();
  const size_t before = allocation_count();
  synthesize(f.lut, f.frames, mapping, f.out, f.statistics.get());
  CHECK(allocation_count() == before);
}

TEST_CASE("frames and outputs that do not fit the LUT are refused before the first pixel") {
  Fixture f;
  const ToneMapping mapping = ToneMapping::identity();
  const cv::Mat untouched = f.out.clone();
  cv::Mat out = f.out;
  OverlapStatistics* statistics = f.statistics.get();
  std::vector<std::byte> small_memory(sizeof(OverlapStatistics));

  SECTION("three frames") {
    f.frames.pop_back();
  }
  SECTION("a frame of another size") {
    f.frames[2] = cv::Mat(90, 160, CV_8UC3);
  }
  SECTION("a grey frame") {
    f.frames[2] = cv::Mat(kImage.y(), kImage.x(), CV_8UC1);
  }
  SECTION("another composite") {
    out = cv::Mat(243, 200, CV_8UC3);
  }
  SECTION("small statistics") {
    statistics = OverlapStatistics::create(small_memory);
  }
  CHECK_THROWS_AS(synthesize(f.lut, f.frames, mapping, out, statistics), std::invalid_argument);
  CHECK(cv::norm(untouched, f.out, cv::NORM_INF) == 0);
}
