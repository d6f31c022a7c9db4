// YUV to BGR in vectors; included once for each set of instructions (vector_stages.cpp).
#if defined(SVCHAIN_VECTOR_COLOUR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SVCHAIN_VECTOR_COLOUR_INL_H
#undef SVCHAIN_VECTOR_COLOUR_INL_H
#else
#define SVCHAIN_VECTOR_COLOUR_INL_H
#endif

#include <algorithm>
#include <array>

#include "algorithms/synthesis/vector_pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace svchain::synthesis::HWY_NAMESPACE {
#if HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR

using Half8 = hn::Half<U8>;  // as many bytes as there are pixels at a time

struct YuvVectors {
  V16 y, u, v;
};

HWY_INLINE YuvVectors load_nv12(const uint8_t* luma, const uint8_t* chroma) {
  alignas(16) static constexpr uint8_t kU[16] = {0, 0, 2, 2, 4, 4, 6, 6, 8, 8, 10, 10, 12, 12, 14, 14};
  alignas(16) static constexpr uint8_t kV[16] = {1, 1, 3, 3, 5, 5, 7, 7, 9, 9, 11, 11, 13, 13, 15, 15};
  const Half8 d;
  const I16 wide;
  const auto groups = hn::LoadU(d, chroma);
  return {hn::PromoteTo(wide, hn::LoadU(d, luma)),
          hn::PromoteTo(wide, hn::TableLookupBytes(groups, hn::LoadDup128(d, kU))),
          hn::PromoteTo(wide, hn::TableLookupBytes(groups, hn::LoadDup128(d, kV)))};
}

HWY_INLINE YuvVectors load_yuyv(const uint8_t* luma) {
  alignas(16) static constexpr uint8_t kU[16] = {1, 0x80, 1, 0x80, 5,  0x80, 5,  0x80,
                                                 9, 0x80, 9, 0x80, 13, 0x80, 13, 0x80};
  alignas(16) static constexpr uint8_t kV[16] = {3,  0x80, 3,  0x80, 7,  0x80, 7,  0x80,
                                                 11, 0x80, 11, 0x80, 15, 0x80, 15, 0x80};
  const U8 d;
  const I16 wide;
  const V8 pixels = hn::LoadU(d, luma);
  return {hn::And(hn::BitCast(wide, pixels), hn::Set(wide, 0xFF)),
          hn::BitCast(wide, hn::TableLookupBytesOr0(pixels, hn::LoadDup128(d, kU))),
          hn::BitCast(wide, hn::TableLookupBytesOr0(pixels, hn::LoadDup128(d, kV)))};
}

/// A matrix in vectors, loaded once.
struct MatrixVectors {
  explicit MatrixVectors(const colour::YuvMatrix& m)
      : offset(hn::Set(I16(), m.offset)),
        of_y(hn::Set(I16(), m.of_y)),
        b_of_u(hn::Set(I16(), m.b_of_u)),
        g_of_u(hn::Set(I16(), m.g_of_u)),
        g_of_v(hn::Set(I16(), m.g_of_v)),
        r_of_v(hn::Set(I16(), m.r_of_v)) {}
  V16 offset, of_y, b_of_u, g_of_u, g_of_v, r_of_v;
};

#if HWY_TARGET == HWY_AVX3_DL
/// For bytes `first` and behind of b g r b g r ..., where they are once b and g are packed into one vector
/// and r, twice, into another: eight of each in every 128 bits.
constexpr std::array<uint8_t, 64> interleaved_from(int first) {
  std::array<uint8_t, 64> indices{};
  for (int i = 0; i < 64; ++i) {
    const int pixel = (first + i) / 3 % 32, channel = (first + i) % 3;
    indices[i] = static_cast<uint8_t>(pixel / 8 * 16 + pixel % 8 +
                                      (channel == 1   ? 8
                                       : channel == 2 ? 64
                                                      : 0));
  }
  return indices;
}
alignas(64) inline constexpr std::array<uint8_t, 64> kFirstInterleaved = interleaved_from(0),
                                                     kLastInterleaved = interleaved_from(64);

/// Saturated to bytes. Two permutes across two vectors, where Highway's way takes some twenty shuffles.
HWY_INLINE void store_interleaved(V16 b, V16 g, V16 r, uint8_t* bgr) {
  const __m512i bg = _mm512_packus_epi16(b.raw, g.raw), rr = _mm512_packus_epi16(r.raw, r.raw);
  _mm512_storeu_si512(bgr, _mm512_permutex2var_epi8(bg, _mm512_load_si512(kFirstInterleaved.data()), rr));
  const __m512i last = _mm512_permutex2var_epi8(bg, _mm512_load_si512(kLastInterleaved.data()), rr);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(bgr + 64), _mm512_castsi512_si256(last));
}
#else
/// Saturated to bytes.
HWY_INLINE void store_interleaved(V16 b, V16 g, V16 r, uint8_t* bgr) {
  const Half8 d;
  hn::StoreInterleaved3(hn::DemoteTo(d, b), hn::DemoteTo(d, g), hn::DemoteTo(d, r), d, bgr);
}
#endif

/// bgr_of (colour/yuv.h).
HWY_INLINE void store_bgr(const MatrixVectors& m, const YuvVectors& yuv, uint8_t* bgr) {
  const I16 d;
  const V16 centre = hn::Set(d, 128);
  const V16 y = hn::ShiftLeft<7>(hn::Sub(yuv.y, m.offset));
  const V16 du = hn::ShiftLeft<7>(hn::Sub(yuv.u, centre)), dv = hn::ShiftLeft<7>(hn::Sub(yuv.v, centre));
  const V16 luma = hn::Add(hn::MulFixedPoint15(y, m.of_y), hn::Set(d, 16));
  const V16 b = hn::Add(luma, hn::MulFixedPoint15(du, m.b_of_u));
  const V16 g = hn::Add(luma, hn::Add(hn::MulFixedPoint15(du, m.g_of_u), hn::MulFixedPoint15(dv, m.g_of_v)));
  const V16 r = hn::Add(luma, hn::MulFixedPoint15(dv, m.r_of_v));
  store_interleaved(hn::ShiftRight<5>(b), hn::ShiftRight<5>(g), hn::ShiftRight<5>(r), bgr);
}

/// As much of a row as there are lanes.
template <colour::YuvLayout kLayout>
HWY_INLINE void turn_vector(const MatrixVectors& matrix, const uint8_t* luma, const uint8_t* chroma,
                            uint8_t* bgr) {
  if constexpr (kLayout.luma_step == 1)
    store_bgr(matrix, load_nv12(luma, chroma), bgr);
  else
    store_bgr(matrix, load_yuyv(luma), bgr);
}

/// The same from a copy of the last pixels before foreign memory.
template <colour::YuvLayout kLayout>
HWY_NOINLINE void turn_last(const FrameBox& box, const MatrixVectors& matrix, const uint8_t* luma,
                            const uint8_t* chroma, uint8_t* bgr) {
  alignas(kLargestVector) uint8_t last_luma[kLargestVector] = {}, last_chroma[kLargestVector] = {};
  const auto copy = [](uint8_t* to, const uint8_t* from, const uint8_t* end) {
    std::memcpy(to, from, std::min<size_t>(kLargestVector, static_cast<size_t>(end - from)));
  };
  copy(last_luma, luma, box.end);
  copy(last_chroma, chroma, box.chroma_end);
  turn_vector<kLayout>(matrix, last_luma, last_chroma, bgr);
}

/// A run of pixels that begins with a group.
template <colour::YuvLayout kLayout>
HWY_INLINE void turn_run(const FrameBox& box, const MatrixVectors& matrix, const uint8_t* luma,
                         const uint8_t* chroma, size_t count, uint8_t* bgr) {
  const size_t lanes = hn::Lanes(I16());
  const auto fits = [](const uint8_t* from, size_t bytes, const uint8_t* end) {
    return static_cast<size_t>(end - from) >= bytes;
  };
  for (size_t x = 0; x < count; x += lanes, bgr += lanes * kChannels) {
    const uint8_t* const y_at = luma + x * kLayout.luma_step;
    if (fits(y_at, lanes * kLayout.luma_step, box.end) && fits(chroma + x, lanes, box.chroma_end))
      turn_vector<kLayout>(matrix, y_at, chroma + x, bgr);
    else
      turn_last<kLayout>(box, matrix, y_at, chroma + x, bgr);
  }
}

template <colour::YuvLayout kLayout>
void turn_layout_to_bgr(const FrameBox& yuv, std::span<const LutRow> rows, uint8_t* bgr, size_t pitch) {
  const FrameBox box = yuv;  // a copy, which writing cannot change
  const MatrixVectors matrix(*box.matrix);
  for (size_t y = 0; y < rows.size(); ++y, bgr += pitch) {
    const ptrdiff_t inside = (rows[y].start + box.odd_x) % 2;  // of the group that the row begins with
    const ptrdiff_t x = rows[y].start - inside;
    const size_t group = static_cast<size_t>(x + box.odd_x) / 2;
    turn_run<kLayout>(box, matrix, box.origin + static_cast<ptrdiff_t>(y * box.pitch) + x * kLayout.luma_step,
                      box.chroma + (y + box.odd_y) / kLayout.rows * box.pitch + group * kLayout.chroma_step,
                      rows[y].count > 0 ? rows[y].count + static_cast<size_t>(inside) : 0,
                      bgr + x * ptrdiff_t{kChannels});
  }
}

void turn_to_bgr(const FrameBox& yuv, std::span<const LutRow> rows, uint8_t* bgr, size_t pitch) {
  if (yuv.format == colour::PixelFormat::kNv12)
    turn_layout_to_bgr<colour::kNv12Layout>(yuv, rows, bgr, pitch);
  else
    turn_layout_to_bgr<colour::kYuyvLayout>(yuv, rows, bgr, pitch);
}

#endif
}  // namespace svchain::synthesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
