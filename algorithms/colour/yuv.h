#pragma once
// Y'CbCr and RGB in 8 bits, both ways, in fixed point. These formulas are their definition: every kernel
// yields the same bytes. Exactly, with R, G, B in 0..255, kr and kb the luma weights of the standard
// (ITU-R BT.601: 0.299 and 0.114, BT.709: 0.2126 and 0.0722) and kg = 1 - kr - kb:
//   E = kr R + kg G + kb B
//   Y = o + s E,  U = 128 + t (B - E) / (2 - 2 kb),  V = 128 + t (R - E) / (2 - 2 kr)
// with o = 16, s = 219/255, t = 224/255 in the limited range and 0, 1, 1 in the full one.
// In fixed point every product is one `rounded_product` of two numbers of 16 bits, and every sum fits 16 bits
// too. Over all 2^24 values, results are at most 0.56 (to RGB) and 0.52 (to YUV) from the exact formula's,
// where rounding alone takes 0.5. Greys stay greys. Pure functions, any thread.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace svchain::colour {

enum class YuvEncoding : uint8_t { kBt601Limited, kBt601Full, kBt709Limited, kBt709Full };

/// "bt601_limited", "bt601_full", "bt709_limited", "bt709_full", in the order of YuvEncoding.
const std::vector<std::string>& yuv_encoding_names();
/// Nothing for any other name.
std::optional<YuvEncoding> yuv_encoding(std::string_view name);

/// (a b + 2^14) >> 15: what pmulhrsw and sqrdmulh give for 16 bits.
constexpr int32_t rounded_product(int32_t a, int32_t b) {
  return (a * b + (1 << 14)) >> 15;
}

struct YuvMatrix {
  int16_t offset;                                // of Y
  std::array<int16_t, 3> y_of, u_of, v_of;       // from b, g, r, in 1/32768
  int16_t of_y, b_of_u, g_of_u, g_of_v, r_of_v;  // to b, g, r, in 1/8192
};

constexpr YuvMatrix make_yuv_matrix(double kr, double kb, bool limited) {
  const double kg = 1 - kr - kb;
  const double s = limited ? 219.0 / 255 : 1, t = limited ? 224.0 / 255 : 1;
  const double u = t / (2 - 2 * kb), v = t / (2 - 2 * kr);
  const auto fixed = [](double value, int one) {
    return static_cast<int16_t>(value * one + (value < 0 ? -0.5 : 0.5));
  };
  const auto row = [&](double b, double g, double r) {
    return std::array{fixed(b, 32768), fixed(g, 32768), fixed(r, 32768)};
  };
  return {static_cast<int16_t>(limited ? 16 : 0),
          row(s * kb, s * kg, s * kr),
          row(u * (1 - kb), -u * kg, -u * kr),
          row(-v * kb, -v * kg, v * (1 - kr)),
          fixed(1 / s, 8192),
          fixed(1 / u, 8192),
          fixed(-kb / (kg * u), 8192),
          fixed(-kr / (kg * v), 8192),
          fixed(1 / v, 8192)};
}

inline constexpr std::array<YuvMatrix, 4> kYuvMatrices = {
    make_yuv_matrix(0.299, 0.114, true), make_yuv_matrix(0.299, 0.114, false),
    make_yuv_matrix(0.2126, 0.0722, true), make_yuv_matrix(0.2126, 0.0722, false)};

constexpr const YuvMatrix& yuv_matrix(YuvEncoding encoding) {
  return kYuvMatrices[static_cast<size_t>(encoding)];
}

constexpr uint8_t clamped(int32_t value) {
  return static_cast<uint8_t>(std::clamp(value, 0, 255));
}

using Bgr = std::array<uint8_t, 3>;

/// What U and V add to every pixel of a group, in 1/32.
struct Tint {
  int32_t b, g, r;
};
constexpr Tint tint_of(const YuvMatrix& m, int32_t u, int32_t v) {
  const int32_t du = (u - 128) * 128, dv = (v - 128) * 128;
  return {rounded_product(du, m.b_of_u), rounded_product(du, m.g_of_u) + rounded_product(dv, m.g_of_v),
          rounded_product(dv, m.r_of_v)};
}
/// What a pixel's Y shows with its group's tint; values that no colour has are clamped channel by channel.
constexpr Bgr bgr_of(const YuvMatrix& m, int32_t y, const Tint& tint) {
  const int32_t luma = rounded_product((y - m.offset) * 128, m.of_y) + 16;
  return {clamped((luma + tint.b) >> 5), clamped((luma + tint.g) >> 5), clamped((luma + tint.r) >> 5)};
}
constexpr Bgr bgr_of(const YuvMatrix& m, int32_t y, int32_t u, int32_t v) {
  return bgr_of(m, y, tint_of(m, u, v));
}

/// One row of a matrix from RGB. b, g and r count 1/128, so that the mean of two or four pixels is exact.
constexpr int32_t mixed(const std::array<int16_t, 3>& row, int32_t b, int32_t g, int32_t r) {
  const int32_t sum = rounded_product(b, row[0]) + rounded_product(g, row[1]) + rounded_product(r, row[2]);
  return (sum + 64) >> 7;
}
constexpr uint8_t luma_of(const YuvMatrix& m, int32_t b, int32_t g, int32_t r) {
  return clamped(m.offset + mixed(m.y_of, b * 128, g * 128, r * 128));
}
/// U (`m.u_of`) or V (`m.v_of`) of a group of four pixels, from the sums of their channels (0..1020).
constexpr uint8_t chroma_of(const std::array<int16_t, 3>& row, int32_t b, int32_t g, int32_t r) {
  return clamped(128 + mixed(row, b * 32, g * 32, r * 32));
}

}  // namespace svchain::colour
