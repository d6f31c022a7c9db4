#include <cstring>

#include "algorithms/synthesis/stages.h"

namespace svchain::synthesis {
namespace {

using colour::PixelFormat;
using colour::YuvLayout;

/// Three channels in one number, far enough apart for their sums in `bilinear`, which take 18 bits: one
/// multiplication weighs all of them, which halves the time.
constexpr int kChannelBits = 21;
constexpr uint64_t together(uint64_t first, uint64_t second, uint64_t third) {
  return first | second << kChannelBits | third << (2 * kChannelBits);
}

/// `bilinear` of three channels at once.
struct Weights {
  Weights(uint32_t fx, uint32_t fy)
      : w11(fx * fy),
        w10(fx * kOnePixel - w11),
        w01(fy * kOnePixel - w11),
        w00(kOnePixel * kOnePixel - w11 - w10 - w01) {}

  std::array<uint8_t, 3> mean(uint64_t p00, uint64_t p10, uint64_t p01, uint64_t p11) const {
    const uint64_t sum = p00 * w00 + p10 * w10 + p01 * w01 + p11 * w11 + together(512, 512, 512);
    return {static_cast<uint8_t>(sum >> 10), static_cast<uint8_t>(sum >> (kChannelBits + 10)),
            static_cast<uint8_t>(sum >> (2 * kChannelBits + 10))};
  }

  uint64_t w11, w10, w01, w00;
};

uint64_t pixel_at(const uint8_t* bgr) {
  return together(bgr[0], bgr[1], bgr[2]);
}

void sample_bgr(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const uint8_t* const origin = box.origin;
  const size_t pitch = box.pitch;
  uint8_t* out = samples.channel[0];
  for (const uint32_t* const end = entries + count; entries != end; ++entries, ++out) {
    const uint32_t x = entry_x(*entries), y = entry_y(*entries);
    const uint8_t* upper = origin + (y >> kFractionBits) * pitch + (x >> kFractionBits) * kChannels;
    const uint8_t* lower = upper + pitch;
    const Weights weights(x % kOnePixel, y % kOnePixel);
    const auto bgr = weights.mean(pixel_at(upper), pixel_at(upper + kChannels), pixel_at(lower),
                                  pixel_at(lower + kChannels));
    for (size_t c = 0; c < kChannels; ++c) out[c * kBlockPixels] = bgr[c];
  }
}

template <YuvLayout kLayout>
void sample_yuv(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const colour::YuvMatrix matrix = *box.matrix;
  const FrameBox frame = box;  // a copy, which writing samples cannot change
  uint8_t* out = samples.channel[0];
  for (const uint32_t* const end = entries + count; entries != end; ++entries, ++out) {
    const uint32_t x = entry_x(*entries), y = entry_y(*entries);
    const uint32_t column = x >> kFractionBits, row = y >> kFractionBits;
    const uint8_t* luma = frame.origin + row * frame.pitch + column * kLayout.luma_step;
    const uint8_t* upper = frame.chroma + (row + frame.odd_y) / kLayout.rows * frame.pitch;
    const uint8_t* lower = frame.chroma + (row + frame.odd_y + 1) / kLayout.rows * frame.pitch;
    const uint32_t left = (column + frame.odd_x) / 2 * kLayout.chroma_step;
    const uint32_t right = (column + frame.odd_x + 1) / 2 * kLayout.chroma_step;
    const auto pixel = [](const uint8_t* y_at, const uint8_t* u_at) {
      return together(*y_at, *u_at, u_at[kLayout.v_offset]);
    };
    const auto yuv = Weights(x % kOnePixel, y % kOnePixel)
                         .mean(pixel(luma, upper + left), pixel(luma + kLayout.luma_step, upper + right),
                               pixel(luma + frame.pitch, lower + left),
                               pixel(luma + frame.pitch + kLayout.luma_step, lower + right));
    const colour::Bgr bgr = colour::bgr_of(matrix, yuv[0], yuv[1], yuv[2]);
    for (size_t c = 0; c < kChannels; ++c) out[c * kBlockPixels] = bgr[c];
  }
}

void sample(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  if (box.empty()) {
    for (auto& channel : samples.channel) std::memset(channel, 0, count);
    return;
  }
  switch (box.format) {
    case PixelFormat::kBgr8:
      return sample_bgr(box, entries, count, samples);
    case PixelFormat::kNv12:
      return sample_yuv<colour::kNv12Layout>(box, entries, count, samples);
    case PixelFormat::kYuyv:
      return sample_yuv<colour::kYuyvLayout>(box, entries, count, samples);
  }
}

void undo_falloff(const Falloff& falloff, const uint32_t* entries, size_t count, Samples& samples) {
  for (size_t i = 0; i < count; ++i) {
    const auto x = static_cast<int32_t>(entry_x(entries[i])), y = static_cast<int32_t>(entry_y(entries[i]));
    const int32_t q2 = falloff.radial.q2(x - falloff.centre_x, y - falloff.centre_y);
    const int32_t factor = radial_factor(falloff.a1, falloff.a2, q2);
    for (auto& channel : samples.channel) channel[i] = unfade(channel[i], factor);
  }
}

void add(const Samples& samples, size_t count, BlockSamples& into) {
  for (size_t c = 0; c < kChannels; ++c) {
    uint32_t sum = 0, sum_of_squares = 0, clipped = 0;
    for (size_t i = 0; i < count; ++i) {
      const uint32_t v = samples.channel[c][i];
      sum += v;
      sum_of_squares += v * v;
      clipped += is_clipped(samples.channel[c][i]);
    }
    into.sum[c] += sum;
    into.sum_of_squares[c] += sum_of_squares;
    into.clipped[c] += clipped;
  }
}

ToneTables tone_tables(const std::array<ToneMapping::Curve, kChannels>& curves) {
  ToneTables tables;
  for (size_t c = 0; c < kChannels; ++c) std::memcpy(tables.channel[c], curves[c].data(), 256);
  return tables;
}

void tone_map(const ToneTables& tables, size_t count, Samples& samples) {
  for (size_t c = 0; c < kChannels; ++c)
    for (size_t i = 0; i < count; ++i) samples.channel[c][i] = tables.channel[c][samples.channel[c][i]];
}

void blend(Samples& a, const Samples& b, const uint8_t* weights, size_t count) {
  for (size_t c = 0; c < kChannels; ++c)
    for (size_t i = 0; i < count; ++i)
      a.channel[c][i] = synthesis::blend(a.channel[c][i], b.channel[c][i], weights[i]);
}

void pack(const Samples& samples, size_t count, uint8_t* bgr) {
  for (size_t i = 0; i < count; ++i)
    for (const auto& channel : samples.channel) *bgr++ = channel[i];
}

}  // namespace

const Stages kPortableStages = {sample, undo_falloff, add, tone_tables, tone_map, blend, pack};

}  // namespace svchain::synthesis
