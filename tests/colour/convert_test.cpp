#include "algorithms/colour/convert.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "tests/allocation_count.h"
#include "tests/catch.h"

using namespace svchain::colour;
using svchain::testing::allocation_count;

namespace {

/// A picture in YUV with rows that are longer than they need to be.
struct OwnedYuv {
  OwnedYuv(PixelFormat format, cv::Size size, YuvEncoding encoding)
      : bytes(size.height * 3 / 2, 2 * size.width + 6, CV_8U, cv::Scalar(77)),
        picture((format == PixelFormat::kNv12 ? nv12_picture : yuyv_picture)(
            size.width, size.height, bytes.step[0], bytes.data, encoding)) {}
  cv::Mat bytes;
  Picture picture;
};

/// Colours that change slowly, all over the cube.
cv::Mat smooth_picture(cv::Size size) {
  cv::Mat picture(size, CV_8UC3);
  picture.forEach<cv::Vec3b>([&](cv::Vec3b& p, const int* at) {
    const double x = double(at[1]) / size.width, y = double(at[0]) / size.height;
    p = cv::Vec3b(cv::saturate_cast<uchar>(40 + 170 * x), cv::saturate_cast<uchar>(50 + 160 * y),
                  cv::saturate_cast<uchar>(60 + 75 * (x + 1 - y)));
  });
  return picture;
}

cv::Mat random_picture(cv::Size size) {
  cv::Mat picture(size, CV_8UC3);
  cv::RNG(7).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

double largest_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

cv::Mat converted(const Picture& yuv) {
  cv::Mat bgr(yuv.height_px, yuv.width_px, CV_8UC3);
  bgr_from_yuv(yuv, bgr_picture(bgr));
  return bgr;
}

const cv::Size kSize(128, 96);

}  // namespace

TEST_CASE("smooth colours come back from NV12 and YUYV within 3 levels, in every encoding") {
  const auto format = GENERATE(PixelFormat::kNv12, PixelFormat::kYuyv);
  const auto encoding = static_cast<YuvEncoding>(GENERATE(0, 1, 2, 3));
  const cv::Mat bgr = smooth_picture(kSize);
  OwnedYuv yuv(format, kSize, encoding);
  yuv_from_bgr(bgr_picture(bgr), yuv.picture);
  CHECK(largest_difference(converted(yuv.picture), bgr) <= 3);
}

TEST_CASE("every byte is where NV12 and YUYV have it") {
  cv::Mat bgr(2, 4, CV_8UC3, cv::Scalar(0, 0, 0));
  bgr.at<cv::Vec3b>(0, 0) = {255, 255, 255};
  bgr.at<cv::Vec3b>(1, 3) = {255, 0, 0};
  const YuvMatrix& m = yuv_matrix(YuvEncoding::kBt601Full);
  const uint8_t blue = luma_of(m, 255, 0, 0);
  const uint8_t u4 = chroma_of(m.u_of, 255, 0, 0), v4 = chroma_of(m.v_of, 255, 0, 0);
  const uint8_t u2 = chroma_of(m.u_of, 510, 0, 0), v2 = chroma_of(m.v_of, 510, 0, 0);

  cv::Mat bytes(3, 4, CV_8U);
  yuv_from_bgr(bgr_picture(bgr), nv12_picture(4, 2, 4, bytes.data, YuvEncoding::kBt601Full));
  CHECK(largest_difference(bytes, (cv::Mat_<uchar>(3, 4) << 255, 0, 0, 0, 0, 0, 0, blue, 128, 128, u4, v4)) ==
        0);

  bytes.create(2, 8, CV_8U);
  yuv_from_bgr(bgr_picture(bgr), yuyv_picture(4, 2, 8, bytes.data, YuvEncoding::kBt601Full));
  CHECK(largest_difference(bytes, (cv::Mat_<uchar>(2, 8) << 255, 128, 0, 128, 0, 128, 0, 128,  //
                                   0, 128, 0, 128, 0, u2, blue, v2)) == 0);
}

TEST_CASE("a group's chroma is that of its pixels' mean, and its pixels get it back") {
  const auto format = GENERATE(PixelFormat::kNv12, PixelFormat::kYuyv);
  const int rows = format == PixelFormat::kNv12 ? 2 : 1;
  const cv::Mat bgr = random_picture(kSize);
  const auto encoding = YuvEncoding::kBt709Limited;
  const YuvMatrix& m = yuv_matrix(encoding);
  OwnedYuv yuv(format, kSize, encoding);
  yuv_from_bgr(bgr_picture(bgr), yuv.picture);
  const cv::Mat back = converted(yuv.picture);
  size_t wrong = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const cv::Rect group(x / 2 * 2, y / rows * rows, 2, rows);
      const cv::Scalar sum = cv::sum(bgr(group)) * (4.0 / group.area());
      const cv::Vec3i s(sum[0], sum[1], sum[2]);
      const auto p = bgr.at<cv::Vec3b>(y, x);
      const Bgr expected = bgr_of(m, luma_of(m, p[0], p[1], p[2]), chroma_of(m.u_of, s[0], s[1], s[2]),
                                  chroma_of(m.v_of, s[0], s[1], s[2]));
      const auto got = back.at<cv::Vec3b>(y, x);
      wrong += got != cv::Vec3b(expected[0], expected[1], expected[2]);
    }
  CHECK(wrong == 0);
}

TEST_CASE("NV12 and YUYV in BT.601's limited range are what OpenCV takes them for, within 2 levels") {
  const cv::Mat bgr = random_picture(kSize);
  cv::Mat bytes(kSize.height * 3 / 2, kSize.width, CV_8U), theirs;
  cv::RNG(3).fill(bytes, cv::RNG::UNIFORM, 0, 256);
  cv::cvtColor(bytes, theirs, cv::COLOR_YUV2BGR_NV12);
  const auto nv12 = nv12_picture(kSize.width, kSize.height, bytes.step[0], bytes.data, {});
  // OpenCV takes Y below 16 for 16, as no limited picture has it.
  for (int y = 0; y < kSize.height; ++y) bytes.row(y) = cv::max(bytes.row(y), 16);
  CHECK(largest_difference(converted(nv12), theirs) <= 2);

  cv::Mat pairs(kSize, CV_8UC2);
  cv::RNG(4).fill(pairs, cv::RNG::UNIFORM, 16, 256);
  cv::cvtColor(pairs, theirs, cv::COLOR_YUV2BGR_YUYV);
  const auto yuyv = yuyv_picture(kSize.width, kSize.height, pairs.step[0], pairs.data, {});
  CHECK(largest_difference(converted(yuyv), theirs) <= 2);
}

TEST_CASE("conversions write no byte beside the picture and allocate nothing") {
  const auto format = GENERATE(PixelFormat::kNv12, PixelFormat::kYuyv);
  const cv::Mat bgr = random_picture(kSize);
  OwnedYuv yuv(format, kSize, YuvEncoding::kBt709Full);
  cv::Mat canvas(kSize.height + 4, kSize.width + 5, CV_8UC3, cv::Scalar(1, 2, 3));
  cv::Mat inner = canvas(cv::Rect({3, 2}, kSize));
  const Picture from = bgr_picture(bgr), to = bgr_picture(inner);

  const size_t before = allocation_count();
  yuv_from_bgr(from, yuv.picture);
  bgr_from_yuv(yuv.picture, to);
  CHECK(allocation_count() == before);

  inner.setTo(cv::Scalar(1, 2, 3));
  CHECK(largest_difference(canvas, cv::Mat(canvas.size(), CV_8UC3, cv::Scalar(1, 2, 3))) == 0);
  const int row = format == PixelFormat::kNv12 ? kSize.width : 2 * kSize.width;
  const cv::Mat padding = yuv.bytes.colRange(row, yuv.bytes.cols);
  CHECK(cv::countNonZero(padding != 77) == 0);
}

TEST_CASE("pictures with half a group, of two sizes or of the wrong formats are refused") {
  cv::Mat bytes(64, 64, CV_8U);
  const auto nv12 = [&](int width, int height) { return nv12_picture(width, height, 64, bytes.data, {}); };
  const auto yuyv = [&](int width, int height) { return yuyv_picture(width, height, 64, bytes.data, {}); };
  const auto refused = [](const Picture& yuv, cv::Size size) {
    cv::Mat bgr(size, CV_8UC3);
    CHECK_THROWS_AS(yuv_from_bgr(bgr_picture(bgr), yuv), std::invalid_argument);
    CHECK_THROWS_AS(bgr_from_yuv(yuv, bgr_picture(bgr)), std::invalid_argument);
  };
  refused(nv12(7, 8), {7, 8});
  refused(nv12(8, 7), {8, 7});
  refused(yuyv(7, 8), {7, 8});
  refused(nv12(8, 8), {8, 6});
  refused(yuyv(8, 8), {10, 8});
  refused({}, {0, 0});
  cv::Mat bgr(7, 8, CV_8UC3);
  CHECK_NOTHROW(yuv_from_bgr(bgr_picture(bgr), yuyv(8, 7)));
  CHECK_THROWS_AS(yuv_from_bgr(nv12(8, 8), bgr_picture(bgr)), std::invalid_argument);
}
