#include "algorithms/colour/convert.h"

#include <algorithm>
#include <stdexcept>

namespace svchain::colour {
namespace {

constexpr int kChannels = 3;

void check(const Picture& bgr, const Picture& yuv) {
  const auto require = [](bool condition, const char* what) {
    if (!condition) throw std::invalid_argument(std::string("colour conversion: ") + what);
  };
  require(bgr.format == PixelFormat::kBgr8 && yuv.format != PixelFormat::kBgr8,
          "expected one BGR and one YUV picture");
  require(!bgr.empty() && !yuv.empty(), "a picture is empty");
  require(bgr.width_px == yuv.width_px && bgr.height_px == yuv.height_px, "the pictures differ in size");
  require(has_whole_groups(yuv.format, yuv.width_px, yuv.height_px),
          "NV12 needs an even width and height, YUYV an even width");
}

template <YuvLayout kLayout>
void write_luma(const YuvMatrix& m, const uint8_t* bgr, int count, uint8_t* luma) {
  for (int i = 0; i < count; ++i, bgr += kChannels)
    luma[i * kLayout.luma_step] = luma_of(m, bgr[0], bgr[1], bgr[2]);
}

/// `upper` and `lower`: the rows of a group; the same twice where it has one.
template <YuvLayout kLayout>
void write_chroma(const YuvMatrix& m, const uint8_t* upper, const uint8_t* lower, int groups, uint8_t* u) {
  for (int i = 0; i < groups; ++i, upper += 2 * kChannels, lower += 2 * kChannels) {
    const auto sum = [&](int c) { return upper[c] + upper[c + kChannels] + lower[c] + lower[c + kChannels]; };
    const int32_t b = sum(0), g = sum(1), r = sum(2);
    u[i * kLayout.chroma_step] = chroma_of(m.u_of, b, g, r);
    u[i * kLayout.chroma_step + kLayout.v_offset] = chroma_of(m.v_of, b, g, r);
  }
}

template <YuvLayout kLayout>
void write_yuv(const Picture& bgr, const Picture& yuv) {
  const YuvMatrix m = yuv_matrix(yuv.encoding);
  for (int y = 0; y < yuv.height_px; y += kLayout.rows) {
    const uint8_t* upper = bgr.pixels + y * bgr.pitch_bytes;
    const uint8_t* lower = upper + (kLayout.rows - 1) * bgr.pitch_bytes;
    uint8_t* luma = yuv.pixels + y * yuv.pitch_bytes;
    write_luma<kLayout>(m, upper, yuv.width_px, luma);
    if (kLayout.rows == 2) write_luma<kLayout>(m, lower, yuv.width_px, luma + yuv.pitch_bytes);
    write_chroma<kLayout>(m, upper, lower, yuv.width_px / 2,
                          yuv.chroma + (y / kLayout.rows) * yuv.pitch_bytes);
  }
}

template <YuvLayout kLayout>
void write_bgr(const Picture& yuv, const Picture& bgr) {
  const YuvMatrix m = yuv_matrix(yuv.encoding);
  for (int y = 0; y < yuv.height_px; ++y) {
    const uint8_t* luma = yuv.pixels + y * yuv.pitch_bytes;
    const uint8_t* u = yuv.chroma + (y / kLayout.rows) * yuv.pitch_bytes;
    uint8_t* out = bgr.pixels + y * bgr.pitch_bytes;
    for (int x = 0; x < yuv.width_px; ++x, out += kChannels) {
      const uint8_t* group = u + (x / 2) * kLayout.chroma_step;
      const Bgr pixel = bgr_of(m, luma[x * kLayout.luma_step], group[0], group[kLayout.v_offset]);
      for (int c = 0; c < kChannels; ++c) out[c] = pixel[c];
    }
  }
}

}  // namespace

void yuv_from_bgr(const Picture& bgr, const Picture& yuv) {
  check(bgr, yuv);
  yuv.format == PixelFormat::kNv12 ? write_yuv<kNv12Layout>(bgr, yuv) : write_yuv<kYuyvLayout>(bgr, yuv);
}

void bgr_from_yuv(const Picture& yuv, const Picture& bgr) {
  check(bgr, yuv);
  yuv.format == PixelFormat::kNv12 ? write_bgr<kNv12Layout>(yuv, bgr) : write_bgr<kYuyvLayout>(yuv, bgr);
}

void bgr_from(const Picture& picture, const Picture& bgr) {
  if (is_yuv(picture.format)) return bgr_from_yuv(picture, bgr);
  const size_t from_step = bytes_per_px(picture.format);
  for (int y = 0; y < picture.height_px; ++y) {
    const uint8_t* from = picture.pixels + static_cast<size_t>(y) * picture.pitch_bytes;
    uint8_t* to = bgr.pixels + static_cast<size_t>(y) * bgr.pitch_bytes;
    for (int x = 0; x < picture.width_px; ++x, from += from_step, to += 3) std::copy_n(from, 3, to);
  }
}

}  // namespace svchain::colour
