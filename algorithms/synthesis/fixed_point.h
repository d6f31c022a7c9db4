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

/// A sample that tells little about brightness: at most 2, or at least 253.
constexpr bool is_clipped(uint8_t value) {
  return static_cast<uint8_t>(value + 3) < 6;
}

}  // namespace svchain::synthesis
