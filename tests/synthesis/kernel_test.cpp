// Every kernel that this processor runs against the portable one, byte by byte, and how a kernel is chosen.

#include "algorithms/synthesis/kernel.h"

#include <cstring>
#include <opencv2/core.hpp>
#include <random>

#include "algorithms/colour/convert.h"
#include "algorithms/synthesis/synthesize.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"
#include "tests/synthesis/random_tone_mapping.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;
using colour::Picture;
using colour::PixelFormat;
using colour::YuvEncoding;

namespace {

const Eigen::Vector2i kImage(320, 180);

/// A picture of noise whose memory ends with its last byte.
class NoisePicture {
 public:
  NoisePicture(PixelFormat format, uint32_t seed, size_t padding = 0) {
    const size_t width = kImage.x(), height = kImage.y();
    const size_t row = format == PixelFormat::kBgr8   ? 3 * width
                       : format == PixelFormat::kNv12 ? width
                                                      : 2 * width;
    const size_t rows = format == PixelFormat::kNv12 ? height * 3 / 2 : height;
    const size_t pitch = row + padding;
    bytes_ = std::make_unique<uint8_t[]>(pitch * (rows - 1) + row);
    std::mt19937 random(seed);
    for (size_t i = 0; i < pitch * (rows - 1) + row; ++i) bytes_[i] = static_cast<uint8_t>(random());
    picture_ = {format, YuvEncoding::kBt709Limited, kImage.x(), kImage.y(), pitch, bytes_.get(), nullptr};
    if (format == PixelFormat::kNv12) picture_.chroma = bytes_.get() + height * pitch;
    if (format == PixelFormat::kYuyv) picture_.chroma = bytes_.get() + 1;
  }
  const Picture& picture() const { return picture_; }

 private:
  std::unique_ptr<uint8_t[]> bytes_;
  Picture picture_;
};

/// A car, its frames and one composite after the other.
struct Car {
  Car(PixelFormat format, const Eigen::Vector2i& view_px, const BlendShape& shape = {}, size_t padding = 0)
      : view(view_of(rig, view_px)), owned(rig, view, shape), memory(OverlapStatistics::bytes_for(view)) {
    for (uint32_t i = 0; i < 4; ++i) noise.emplace_back(format, i + 1, padding);
    for (size_t i = 0; i < 4; ++i) frames[i] = noise[i].picture();
  }

  struct Result {
    cv::Mat bytes;
    std::vector<OverlapBlock> overlaps;
  };
  Result run(Kernel kernel, PixelFormat out_format = PixelFormat::kBgr8) {
    Result result;
    const Picture out = empty_composite(out_format, result.bytes);
    OverlapStatistics* statistics = OverlapStatistics::create(memory);
    synthesize(owned.lut(), frames, mapping, out, statistics, kernel);
    result.overlaps.assign(statistics->blocks().begin(), statistics->blocks().end());
    return result;
  }
  Picture empty_composite(PixelFormat format, cv::Mat& bytes) const {
    const int width = view.size_px.x(), height = view.size_px.y();
    if (format == PixelFormat::kNv12) {
      bytes.create(height * 3 / 2, width, CV_8U);
      return colour::nv12_picture(width, height, bytes.step[0], bytes.data, {});
    }
    if (format == PixelFormat::kBgr8) {
      bytes.create(height, width, CV_8UC3);
      return colour::bgr_picture(bytes);
    }
    bytes.create(height, width, CV_8UC4);
    return colour::bgrx_picture(width, height, bytes.step[0], bytes.data);
  }
  /// Bytes of the composite and entries of the statistics that differ from the portable kernel's.
  size_t differences(Kernel kernel, PixelFormat out_format = PixelFormat::kBgr8) {
    const Result expected = run(Kernel::kPortable, out_format), got = run(kernel, out_format);
    if (got.overlaps.size() != expected.overlaps.size()) return 1000000;
    const cv::Mat unequal = got.bytes != expected.bytes;
    size_t differing = cv::countNonZero(unequal.reshape(1));
    for (size_t i = 0; i < got.overlaps.size(); ++i)
      differing += std::memcmp(&got.overlaps[i], &expected.overlaps[i], sizeof(OverlapBlock)) != 0;
    return differing;
  }

  geometry::Rig rig = four_cameras(kImage);
  geometry::View view;
  OwnedLut owned;
  std::vector<std::byte> memory;
  std::vector<NoisePicture> noise;
  std::array<Picture, 4> frames;
  ToneMapping mapping = random_tone_mapping();
};

Kernel any_kernel() {
  return GENERATE(from_range(runnable_kernels()));
}

}  // namespace

TEST_CASE("every kernel gives the portable one's composite and statistics, byte by byte") {
  const Kernel kernel = any_kernel();
  const auto format = GENERATE(PixelFormat::kBgr8, PixelFormat::kNv12, PixelFormat::kYuyv);
  CAPTURE(name_of(kernel), int(format));
  SECTION("of a view with whole blocks") {
    CHECK(Car(format, {200, 240}).differences(kernel) == 0);
  }
  SECTION("of views whose last blocks are ragged") {
    for (const Eigen::Vector2i& size : {Eigen::Vector2i(201, 243), {41, 39}, {61, 75}, {163, 7}})
      CHECK(Car(format, size).differences(kernel) == 0);
  }
  SECTION("with hard seams, and with a binary decision") {
    CHECK(Car(format, {201, 243}, {0, BlendCurve::kSmooth}).differences(kernel) == 0);
    CHECK(Car(format, {201, 243}, {60, BlendCurve::kBinary}).differences(kernel) == 0);
  }
  SECTION("of frames with room between their rows, or so much that offsets outgrow 16 bits") {
    CHECK(Car(format, {201, 243}, {}, 7).differences(kernel) == 0);
    CHECK(Car(format, {201, 243}, {}, 40000).differences(kernel) == 0);
  }
  SECTION("into NV12, and into BGRX") {
    CHECK(Car(format, {202, 244}).differences(kernel, PixelFormat::kNv12) == 0);
    CHECK(Car(format, {201, 243}).differences(kernel, PixelFormat::kBgrx8) == 0);
  }
  SECTION("where a frame is missing") {
    Car car(format, {201, 243});
    car.frames[2] = {};
    CHECK(car.differences(kernel) == 0);
  }
  SECTION("where frames are clipped") {
    Car car(format, {201, 243});
    for (const Picture& frame : car.frames)
      for (int y = 0; y < kImage.y(); ++y)
        for (int x = 0; x < kImage.x(); ++x)
          frame.pixels[y * frame.pitch_bytes + x] = static_cast<uint8_t>((x / 9 + y / 7) % 2 ? 255 : x % 4);
    CHECK(car.differences(kernel) == 0);
  }
}

TEST_CASE("every kernel undoes falloff as the portable one does") {
  const Kernel kernel = any_kernel();
  const auto format = GENERATE(PixelFormat::kBgr8, PixelFormat::kNv12);
  Car car(format, {201, 243});
  SECTION("of some cameras") {
    car.mapping.falloff[1] = {1229, -410};
    car.mapping.falloff[2] = {-820, 2048};
  }
  SECTION("as strong as it can be") {
    car.mapping.falloff = {{{kLargestFalloff, kLargestFalloff},
                            {-kLargestFalloff, -kLargestFalloff},
                            {kLargestFalloff, -kLargestFalloff},
                            {-kLargestFalloff, kLargestFalloff}}};
  }
  CHECK(car.differences(kernel) == 0);
}

TEST_CASE("BGRX shows what BGR shows, and the fourth byte is 255") {
  Car car(PixelFormat::kBgr8, {201, 243});
  const cv::Mat bgr = car.run(any_kernel()).bytes, bgrx = car.run(any_kernel(), PixelFormat::kBgrx8).bytes;
  std::array<cv::Mat, 4> channels;
  cv::split(bgrx, channels.data());
  CHECK(cv::countNonZero(channels[3] != 255) == 0);
  cv::Mat shown;
  cv::merge(channels.data(), 3, shown);
  CHECK(cv::norm(shown, bgr, cv::NORM_INF) == 0);
  cv::Mat converted(bgr.size(), CV_8UC3);
  cv::Mat bytes = bgrx.clone();
  colour::bgr_from(colour::bgrx_picture(bytes.cols, bytes.rows, bytes.step[0], bytes.data),
                   colour::bgr_picture(converted));
  CHECK(cv::norm(converted, bgr, cv::NORM_INF) == 0);
}

TEST_CASE("frames in BGRX are refused") {
  Car car(PixelFormat::kBgr8, {40, 40});
  car.frames[1].format = PixelFormat::kBgrx8;
  CHECK_THROWS_WITH(car.run(best_kernel()), Catch::Matchers::Contains("a frame is BGRX"));
}

TEST_CASE("the sample of a frame's last pixels is the same with every kernel") {
  const Kernel kernel = any_kernel();
  const auto format = GENERATE(PixelFormat::kBgr8, PixelFormat::kNv12, PixelFormat::kYuyv);
  Car car(format, {202, 244});
  std::vector<std::byte> memory(car.owned.bytes().begin(), car.owned.bytes().end());
  const GeometricLut lut(memory);
  for (const LutBlock& block : lut.blocks()) {  // every box moves to the right lower corner
    for (LutSource& source : const_cast<LutBlock&>(block).sources) {
      source.x = static_cast<uint16_t>(kImage.x() - source.width);
      source.y = static_cast<uint16_t>(kImage.y() - source.height);
    }
  }
  cv::Mat expected(244, 202, CV_8UC3), got(244, 202, CV_8UC3);
  synthesize(lut, car.frames, car.mapping, colour::bgr_picture(expected), nullptr, Kernel::kPortable);
  synthesize(lut, car.frames, car.mapping, colour::bgr_picture(got), nullptr, kernel);
  CHECK(cv::norm(expected, got, cv::NORM_INF) == 0);
}

TEST_CASE("no kernel allocates") {
  const Kernel kernel = any_kernel();
  const auto format = GENERATE(PixelFormat::kBgr8, PixelFormat::kNv12, PixelFormat::kYuyv);
  Car car(format, {202, 244});
  cv::Mat out(244, 202, CV_8UC3);
  const Picture target = colour::bgr_picture(out);
  OverlapStatistics* statistics = OverlapStatistics::create(car.memory);
  const GeometricLut lut = car.owned.lut();
  const size_t before = allocation_count();
  synthesize(lut, car.frames, car.mapping, target, statistics, kernel);
  CHECK(allocation_count() == before);
}

TEST_CASE("the portable kernel runs everywhere, and the best one is the last that runs") {
  const auto runnable = runnable_kernels();
  REQUIRE(!runnable.empty());
  CHECK(runnable.front() == Kernel::kPortable);
  CHECK(runnable.back() == best_kernel());
  for (const Kernel kernel : runnable) {
    CHECK(can_run(kernel));
    CHECK(kernel_named(name_of(kernel)).value() == kernel);
  }
}

TEST_CASE("a kernel that this processor lacks is refused, by name and in a call, and told what there is") {
  const Kernel lacking = can_run(Kernel::kNeon) ? Kernel::kAvx2 : Kernel::kNeon;
  const auto refused = kernel_named(name_of(lacking));
  REQUIRE(!refused);
  CHECK_THAT(refused.error()[0].message, Catch::Matchers::Contains("\"" + name_of(lacking) + "\"") &&
                                             Catch::Matchers::Contains("only portable"));
  Car car(PixelFormat::kBgr8, {40, 40});
  CHECK_THROWS_WITH(car.run(lacking), Catch::Matchers::Contains("does not run the kernel"));
}

TEST_CASE("an unknown kernel is a fault that names the nearest") {
  const auto refused = kernel_named("avx521");
  REQUIRE(!refused);
  CHECK_THAT(refused.error()[0].message, Catch::Matchers::Contains("\"avx521\"") &&
                                             Catch::Matchers::Contains("portable, avx2, avx512 or neon") &&
                                             Catch::Matchers::Contains("did you mean \"avx512\"?"));
}

TEST_CASE("parts in any order make the whole, pixels and statistics, whatever their number") {
  for (const PixelFormat out_format : {PixelFormat::kBgr8, PixelFormat::kBgrx8, PixelFormat::kNv12}) {
    Car car(PixelFormat::kBgr8, {202, 244});
    const auto whole = car.run(best_kernel(), out_format);
    for (const int count : {2, 5, 1000}) {
      cv::Mat bytes;
      const Picture out = car.empty_composite(out_format, bytes);
      bytes.setTo(cv::Scalar::all(7));
      const GeometricLut lut = car.owned.lut();
      OverlapStatistics* statistics = OverlapStatistics::create(car.memory);
      statistics->expect(lut.header().overlap_count);
      for (int i = count - 1; i >= 0; --i)
        synthesize_part({i, count}, lut, car.frames, car.mapping, out, statistics, best_kernel());
      CHECK(cv::norm(bytes, whole.bytes, cv::NORM_INF) == 0);
      REQUIRE(statistics->count == whole.overlaps.size());
      CHECK(std::memcmp(statistics->blocks().data(), whole.overlaps.data(),
                        whole.overlaps.size() * sizeof(OverlapBlock)) == 0);
    }
  }
}

TEST_CASE("parts refuse statistics that do not expect the LUT's overlaps") {
  Car car(PixelFormat::kBgr8, {202, 244});
  cv::Mat bytes(244, 202, CV_8UC3);
  OverlapStatistics* statistics = OverlapStatistics::create(car.memory);
  CHECK_THROWS_AS(synthesize_part({}, car.owned.lut(), car.frames, random_tone_mapping(),
                                  colour::bgr_picture(bytes), statistics, best_kernel()),
                  std::invalid_argument);
}
