#include <algorithm>
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
    for (size_t c = 0; c < kChannels; ++c) out[c * kStagePixels] = bgr[c];
  }
}

/// A pixel of a YUV box.
template <YuvLayout kLayout>
colour::Bgr pixel_of(const FrameBox& box, size_t column, size_t row) {
  const size_t group = (column + box.odd_x) / 2;
  const uint8_t* luma = box.origin + row * box.pitch + column * kLayout.luma_step;
  const uint8_t* u = box.chroma + (row + box.odd_y) / kLayout.rows * box.pitch + group * kLayout.chroma_step;
  return colour::bgr_of(*box.matrix, *luma, u[0], u[kLayout.v_offset]);
}

template <YuvLayout kLayout>
void sample_yuv(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const FrameBox frame = box;  // a copy, which writing samples cannot change
  uint8_t* out = samples.channel[0];
  for (const uint32_t* const end = entries + count; entries != end; ++entries, ++out) {
    const uint32_t x = entry_x(*entries), y = entry_y(*entries);
    const auto pixel = [&](uint32_t right, uint32_t down) {
      return pixel_at(
          pixel_of<kLayout>(frame, (x >> kFractionBits) + right, (y >> kFractionBits) + down).data());
    };
    const auto bgr =
        Weights(x % kOnePixel, y % kOnePixel).mean(pixel(0, 0), pixel(1, 0), pixel(0, 1), pixel(1, 1));
    for (size_t c = 0; c < kChannels; ++c) out[c * kStagePixels] = bgr[c];
  }
}

uint8_t* put(const colour::Bgr& pixel, uint8_t* out) {
  for (const uint8_t value : pixel) *out++ = value;
  return out;
}

/// `count` pixels, `inside` of the first group.
template <YuvLayout kLayout>
void turn_run(const colour::YuvMatrix& m, const uint8_t* luma, const uint8_t* u, size_t inside, size_t count,
              uint8_t* out) {
  for (; count > 0; u += kLayout.chroma_step, inside = 0) {
    const colour::Tint tint = colour::tint_of(m, u[0], u[kLayout.v_offset]);
    for (size_t i = inside; i < 2 && count > 0; ++i, --count, luma += kLayout.luma_step)
      out = put(colour::bgr_of(m, *luma, tint), out);
  }
}

template <YuvLayout kLayout>
void turn_layout_to_bgr(const FrameBox& box, std::span<const LutRow> rows, uint8_t* bgr, size_t pitch) {
  const colour::YuvMatrix matrix = *box.matrix;
  for (size_t y = 0; y < rows.size(); ++y) {
    const size_t x = rows[y].start;
    const uint8_t* u = box.chroma + (y + box.odd_y) / kLayout.rows * box.pitch;
    turn_run<kLayout>(matrix, box.origin + y * box.pitch + x * kLayout.luma_step,
                      u + (x + box.odd_x) / 2 * kLayout.chroma_step, (x + box.odd_x) % 2, rows[y].count,
                      bgr + y * pitch + x * kChannels);
  }
}

void turn_to_bgr(const FrameBox& yuv, std::span<const LutRow> rows, uint8_t* bgr, size_t pitch) {
  const bool nv12 = yuv.format == PixelFormat::kNv12;
  (nv12 ? turn_layout_to_bgr<colour::kNv12Layout> : turn_layout_to_bgr<colour::kYuyvLayout>)(yuv, rows, bgr,
                                                                                             pitch);
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
    case PixelFormat::kBgrx8:
      break;  // no camera gives it, and synthesis refuses it
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

template <PixelFormat kFormat>
void pack(const Samples& samples, size_t first, size_t count, uint8_t* to) {
  for (size_t i = first; i < first + count; ++i) {
    for (const auto& channel : samples.channel) *to++ = channel[i];
    if (kFormat == PixelFormat::kBgrx8) *to++ = 255;
  }
}

template <PixelFormat kFormat>
void pack_list(const Samples& samples, size_t count, uint8_t* to) {
  pack<kFormat>(samples, 0, count, to);
}

template <PixelFormat kFormat>
void pack_rows(const Samples& samples, size_t rows, uint8_t* to, size_t pitch) {
  for (size_t row = 0; row < rows; ++row)
    pack<kFormat>(samples, row * kBlockSize, kBlockSize, to + row * pitch);
}

template <PixelFormat kFormat>
constexpr Packing kPacking = {pack_list<kFormat>, pack_rows<kFormat>};

}  // namespace

const Stages kPortableStages = {turn_to_bgr,
                                sample,
                                undo_falloff,
                                add,
                                tone_tables,
                                tone_map,
                                blend,
                                kPacking<PixelFormat::kBgr8>,
                                kPacking<PixelFormat::kBgrx8>};

}  // namespace svchain::synthesis
