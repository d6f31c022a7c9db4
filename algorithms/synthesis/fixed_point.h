#pragma once
// The arithmetic of synthesis. These formulas are its definition: every kernel yields the same bytes.

#include <cstdint>

namespace svchain::synthesis {

/// Source coordinates count 1/32 px.
inline constexpr int kFractionBits = 5;
inline constexpr uint32_t kOnePixel = 1u << kFractionBits;

/// A LUT entry: x in the low and y in the high 16 bits, in 1/32 px from the top left pixel of the block's
/// box.
constexpr uint32_t make_entry(uint32_t x, uint32_t y) {
  return y << 16 | x;
}
constexpr uint32_t entry_x(uint32_t entry) {
  return entry & 0xFFFF;
}
constexpr uint32_t entry_y(uint32_t entry) {
  return entry >> 16;
}

/// Bilinear sample of the 2x2 pixels p00 p10 / p01 p11 (p10 is to the right of p00), fx and fy in 0..31:
///   (p00 (32-fx)(32-fy) + p10 fx (32-fy) + p01 (32-fx) fy + p11 fx fy + 512) >> 10,
/// the exact weighted mean, halves rounded up.
constexpr uint8_t bilinear(uint32_t p00, uint32_t p10, uint32_t p01, uint32_t p11, uint32_t fx, uint32_t fy) {
  const uint32_t upper = p00 * (kOnePixel - fx) + p10 * fx;
  const uint32_t lower = p01 * (kOnePixel - fx) + p11 * fx;
  return static_cast<uint8_t>((upper * (kOnePixel - fy) + lower * fy + 512) >> 10);
}

/// Blend of two tone-mapped samples, `weight` (0..255) being a's: the nearest integer to (a weight + b (255 -
/// weight)) / 255 (there are no halves), as t = a weight + b (255 - weight) + 128, (t + (t >> 8)) >> 8. All
/// of it fits 16 bits.
constexpr uint8_t blend(uint32_t a, uint32_t b, uint32_t weight) {
  const uint32_t t = a * weight + b * (255 - weight) + 128;
  return static_cast<uint8_t>((t + (t >> 8)) >> 8);
}

/// Radial falloff: a camera's samples are multiplied by 1 + a1 q^2 + a2 q^4, q being the distance from its
/// lens's centre in half image widths. Everything counts 1/4096; q^2 ends at 4, |a1| and |a2| at 4.
inline constexpr int kRadialBits = 12;
inline constexpr int32_t kRadialOne = 1 << kRadialBits;
inline constexpr int32_t kLargestQ2 = 4 * kRadialOne;
inline constexpr int32_t kLargestFalloff = 4 * kRadialOne;

/// From 1/32 px to q, for one camera.
struct RadialScale {
  int32_t scale;  // of 1/32 px to 1/4096 of half the image's width, in 2^-14
  int32_t limit;  // 1/32 px: distances beyond twice half the width count as that, so that all fits 32 bits

  static constexpr RadialScale of(int32_t image_width_px) {
    return {((1 << 26) + image_width_px * 8) / (image_width_px * 16), image_width_px * 32};
  }
  constexpr int32_t length(int32_t distance) const {
    const int32_t within = distance < -limit ? -limit : distance < limit ? distance : limit;
    return (within * scale + (1 << 13)) >> 14;
  }
  /// q^2 of a place that is dx, dy (1/32 px) from the lens's centre.
  constexpr int32_t q2(int32_t dx, int32_t dy) const {
    const int32_t x = length(dx), y = length(dy);
    const int32_t sum = (x * x + y * y) >> kRadialBits;
    return sum < kLargestQ2 ? sum : kLargestQ2;
  }
};

/// 1 + a1 q^2 + a2 q^4, at least 0 and below 16.
constexpr int32_t radial_factor(int32_t a1, int32_t a2, int32_t q2) {
  const int32_t q4 = (q2 * q2) >> kRadialBits;
  const int32_t factor = kRadialOne + ((a1 * q2 + a2 * q4) >> kRadialBits);
  return factor < 0 ? 0 : factor < 16 * kRadialOne ? factor : 16 * kRadialOne - 1;
}
/// A sample times a factor, rounded, at most 255.
constexpr uint8_t unfade(uint32_t value, int32_t factor) {
  const uint32_t product = (value * static_cast<uint32_t>(factor) + kRadialOne / 2) >> kRadialBits;
  return static_cast<uint8_t>(product < 255 ? product : 255);
}

/// A sample that tells little about brightness: at most 2, or at least 253.
constexpr bool is_clipped(uint8_t value) {
  return static_cast<uint8_t>(value + 3) < 6;
}

}  // namespace svchain::synthesis
