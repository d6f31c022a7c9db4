#include "algorithms/colour/yuv.h"

#include <cmath>

#include "tests/catch.h"

using namespace svchain::colour;

namespace {

/// The published formulas in double precision.
struct ExactMatrix {
  double kr, kb;
  bool limited;

  double kg() const { return 1 - kr - kb; }
  double offset() const { return limited ? 16 : 0; }
  double s() const { return limited ? 219.0 / 255 : 1; }
  double t() const { return limited ? 224.0 / 255 : 1; }

  std::array<double, 3> yuv(double b, double g, double r) const {
    const double e = kr * r + kg() * g + kb * b;
    return {offset() + s() * e, 128 + t() * (b - e) / (2 - 2 * kb), 128 + t() * (r - e) / (2 - 2 * kr)};
  }
  std::array<double, 3> bgr(double y, double u, double v) const {
    const double e = (y - offset()) / s();
    const double b = e + (u - 128) / t() * (2 - 2 * kb), r = e + (v - 128) / t() * (2 - 2 * kr);
    return {b, (e - kr * r - kb * b) / kg(), r};
  }
};

const std::array<ExactMatrix, 4> kExact = {
    {{0.299, 0.114, true}, {0.299, 0.114, false}, {0.2126, 0.0722, true}, {0.2126, 0.0722, false}}};

std::array<uint8_t, 3> yuv_of(const YuvMatrix& m, int b, int g, int r) {
  return {luma_of(m, b, g, r), chroma_of(m.u_of, 4 * b, 4 * g, 4 * r),
          chroma_of(m.v_of, 4 * b, 4 * g, 4 * r)};
}

/// Calls f(a, b, c) over a grid that has 0 and 255 on every axis.
template <class F>
void for_grid(F f) {
  for (int a = 0; a < 256; a += 3)
    for (int b = 0; b < 256; b += 3)
      for (int c = 0; c < 256; c += 3) f(a, b, c);
}

/// The largest difference of a result to the exact one, which ends where 8 bits do.
double deviation(const std::array<uint8_t, 3>& got, const std::array<double, 3>& exact) {
  double largest = 0;
  for (size_t i = 0; i < 3; ++i)
    largest = std::max(largest, std::abs(got[i] - std::clamp(exact[i], 0.0, 255.0)));
  return largest;
}

}  // namespace

TEST_CASE("every encoding is what its standard's formulas say, within 0.56 of a level") {
  for (size_t e = 0; e < 4; ++e) {
    INFO(yuv_encoding_names()[e]);
    const YuvMatrix& m = yuv_matrix(static_cast<YuvEncoding>(e));
    double to_rgb = 0, to_yuv = 0;
    for_grid([&](int y, int u, int v) {
      to_rgb = std::max(to_rgb, deviation(bgr_of(m, y, u, v), kExact[e].bgr(y, u, v)));
    });
    for_grid([&](int b, int g, int r) {
      to_yuv = std::max(to_yuv, deviation(yuv_of(m, b, g, r), kExact[e].yuv(b, g, r)));
    });
    CHECK(to_rgb <= 0.56);
    CHECK(to_yuv <= 0.52);
  }
}

TEST_CASE("the matrices are those that are in print") {
  // BT.601, limited: R = 1.164 (Y - 16) + 1.596 (V - 128) and so on.
  const YuvMatrix& m = yuv_matrix(YuvEncoding::kBt601Limited);
  const auto factor = [](int16_t fixed) { return fixed / 8192.0; };
  CHECK(factor(m.of_y) == Approx(1.164).margin(0.001));
  CHECK(factor(m.r_of_v) == Approx(1.596).margin(0.001));
  CHECK(factor(m.g_of_u) == Approx(-0.392).margin(0.001));
  CHECK(factor(m.g_of_v) == Approx(-0.813).margin(0.001));
  CHECK(factor(m.b_of_u) == Approx(2.017).margin(0.001));
  // JPEG's, and BT.709's luma.
  CHECK(factor(yuv_matrix(YuvEncoding::kBt601Full).r_of_v) == Approx(1.402).margin(0.001));
  CHECK(factor(yuv_matrix(YuvEncoding::kBt601Full).b_of_u) == Approx(1.772).margin(0.001));
  CHECK(factor(yuv_matrix(YuvEncoding::kBt709Full).r_of_v) == Approx(1.5748).margin(0.001));
  CHECK(factor(yuv_matrix(YuvEncoding::kBt709Limited).b_of_u) == Approx(2.112).margin(0.001));
}

TEST_CASE("a grey stays the same grey, there and back") {
  for (const YuvMatrix& m : kYuvMatrices)
    for (int grey = 0; grey < 256; ++grey) {
      const auto [y, u, v] = yuv_of(m, grey, grey, grey);
      CHECK((u == 128 && v == 128));
      const Bgr back = bgr_of(m, y, u, v);
      CHECK((back[0] == back[1] && back[1] == back[2]));
      CHECK(std::abs(back[0] - grey) <= (m.offset > 0 ? 1 : 0));
    }
}

TEST_CASE("black and white are 16 and 235 in the limited range, 0 and 255 in the full one") {
  for (const YuvMatrix& m : kYuvMatrices) {
    const int black = m.offset > 0 ? 16 : 0, white = m.offset > 0 ? 235 : 255;
    CHECK(yuv_of(m, 0, 0, 0)[0] == black);
    CHECK(yuv_of(m, 255, 255, 255)[0] == white);
    CHECK(bgr_of(m, black, 128, 128) == Bgr{0, 0, 0});
    CHECK(bgr_of(m, white, 128, 128) == Bgr{255, 255, 255});
  }
}

TEST_CASE("values that no colour has are clamped, not wrapped") {
  for (const YuvMatrix& m : kYuvMatrices) {
    CHECK(bgr_of(m, 255, 255, 255)[0] == 255);
    CHECK(bgr_of(m, 255, 255, 255)[2] == 255);
    CHECK(bgr_of(m, 0, 0, 0)[0] == 0);
    CHECK(bgr_of(m, 0, 0, 0)[2] == 0);
    CHECK(bgr_of(m, 0, 255, 255)[1] == 0);
    CHECK(bgr_of(m, 255, 0, 0)[1] == 255);
  }
}

TEST_CASE("all that is computed on the way fits 16 bits, signed") {
  for (const YuvMatrix& m : kYuvMatrices) {
    const int32_t luma = rounded_product((255 - m.offset) * 128, m.of_y) + 16;
    const int32_t blue = rounded_product(-128 * 128, m.b_of_u);
    CHECK(luma - blue <= INT16_MAX);
    CHECK(blue >= INT16_MIN);
    CHECK(rounded_product(255 * 128, m.y_of[0]) + rounded_product(255 * 128, m.y_of[1]) +
              rounded_product(255 * 128, m.y_of[2]) + 64 <=
          INT16_MAX);
  }
}

TEST_CASE("an encoding has a name, and no other name is one") {
  for (size_t e = 0; e < 4; ++e) CHECK(yuv_encoding(yuv_encoding_names()[e]) == static_cast<YuvEncoding>(e));
  CHECK(yuv_encoding("bt709_limited") == YuvEncoding::kBt709Limited);
  CHECK_FALSE(yuv_encoding("bt2020"));
  CHECK_FALSE(yuv_encoding(""));
}
