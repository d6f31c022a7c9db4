// Bilinear samples in vectors, for every set of instructions but AVX-512, which has a way of its own
// (avx512_interpolation-inl.h); included once for each.
#if defined(SVCHAIN_VECTOR_INTERPOLATION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SVCHAIN_VECTOR_INTERPOLATION_INL_H
#undef SVCHAIN_VECTOR_INTERPOLATION_INL_H
#else
#define SVCHAIN_VECTOR_INTERPOLATION_INL_H
#endif

#include "algorithms/synthesis/vector_fetch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace svchain::synthesis::HWY_NAMESPACE {
#if HWY_TARGET != HWY_AVX3_DL && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR

/// Sums of neighbouring bytes' products with the signed bytes of `weights`, which fit 16 bits.
HWY_INLINE V16 weighted_pairs(V8 bytes, V8 weights) {
#if HWY_TARGET == HWY_AVX3_DL
  return V16{_mm512_maddubs_epi16(bytes.raw, weights.raw)};
#elif HWY_TARGET == HWY_AVX2
  return V16{_mm256_maddubs_epi16(bytes.raw, weights.raw)};
#else
  const U16 d;
  const auto byte = hn::Set(d, 0xFF);
  const auto a = hn::BitCast(d, bytes), b = hn::BitCast(d, weights);
  return hn::BitCast(I16(), hn::Add(hn::Mul(hn::And(a, byte), hn::And(b, byte)),
                                    hn::Mul(hn::ShiftRight<8>(a), hn::ShiftRight<8>(b))));
#endif
}

/// The weights of `bilinear` at fractions in the low (x) and high (y) half of 32 bits, each 0..31.
struct BilinearWeights {
  explicit BilinearWeights(V32 fractions) {
    const U32 d;
    // In either half f becomes the bytes 32 - f and f. No half borrows from the other: f 256 - f + 32 > 0.
    const V32 bytes = hn::Add(hn::Sub(hn::ShiftLeft<8>(fractions), fractions), hn::Set(d, 0x00200020));
    const V32 of_x = hn::And(bytes, hn::Set(d, 0xFFFF));
    across = hn::BitCast(U8(), hn::Or(of_x, hn::ShiftLeft<16>(of_x)));
    const V32 y = hn::ShiftRight<16>(fractions);
    down = hn::BitCast(I16(), hn::Add(hn::Sub(hn::ShiftLeft<16>(y), y), hn::Set(d, 32)));
  }
  V8 across;  // 32 - fx, fx, twice
  V16 down;   // 32 - fy, fy
};

/// `bilinear` of the bytes p00 p10 p01 p11 in every 32 bits.
HWY_INLINE V32 interpolate(V8 quads, const BilinearWeights& weights) {
  const auto sum = products_summed(weighted_pairs(quads, weights.across), weights.down);
  return hn::BitCast(U32(), hn::ShiftRight<10>(hn::Add(sum, hn::Set(I32(), 512))));
}

/// One byte of every 32 bits of b, g and r goes to each channel.
HWY_INLINE void store_channels(V32 b, V32 g, V32 r, size_t at, Samples& samples) {
  alignas(16) static constexpr uint8_t kByChannel[16] = {0, 4, 8,  12, 1, 5, 9,  13,
                                                         2, 6, 10, 14, 3, 7, 11, 15};
  alignas(kLargestVector) uint32_t lanes[hn::MaxLanes(U32())];
  constexpr size_t kParts = hn::MaxLanes(U32()) / 4;
  for (uint32_t channel = 0; channel < 4; ++channel)
    for (uint32_t part = 0; part < kParts; ++part) lanes[channel * kParts + part] = part * 4 + channel;
  const U32 d;
  const V32 all = hn::Or(b, hn::Or(hn::ShiftLeft<8>(g), hn::ShiftLeft<16>(r)));
  const V8 by_channel = hn::TableLookupBytes(hn::BitCast(U8(), all), hn::LoadDup128(U8(), kByChannel));
  const V8 ordered =
      hn::BitCast(U8(), hn::TableLookupLanes(hn::BitCast(d, by_channel), hn::SetTableIndices(d, lanes)));
  const hn::Half<U8> half;
  const hn::Half<hn::Half<U8>> quarter;
  hn::Store(hn::LowerHalf(quarter, hn::LowerHalf(half, ordered)), quarter, samples.channel[0] + at);
  hn::Store(hn::UpperHalf(quarter, hn::LowerHalf(half, ordered)), quarter, samples.channel[1] + at);
  hn::Store(hn::LowerHalf(quarter, hn::UpperHalf(half, ordered)), quarter, samples.channel[2] + at);
}

/// Pixels 0, 4, 8 ... from `offsets`, one in every 128 bits.
template <class D>
HWY_INLINE hn::Vec<D> fetch_every_fourth(D d, const uint8_t* origin, const uint32_t* offsets, size_t pitch) {
  if constexpr (hn::MaxLanes(D()) == 16) {
    return fetch_pixel(origin + offsets[0], pitch);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, fetch_every_fourth(half, origin, offsets + hn::MaxLanes(half) / 4, pitch),
                       fetch_every_fourth(half, origin, offsets, pitch));
  }
}

/// The same rearranged to 32 bits for each channel.
HWY_INLINE V32 fetch_quads(const uint8_t* origin, const uint32_t* offsets, size_t pitch) {
  alignas(16) static constexpr uint8_t kByChannel[16] = {0, 3, 8,  11, 1,    4,    9,    12,
                                                         2, 5, 10, 13, 0x80, 0x80, 0x80, 0x80};
  const U8 d;
  return hn::BitCast(U32(), hn::TableLookupBytesOr0(fetch_every_fourth(d, origin, offsets, pitch),
                                                    hn::LoadDup128(d, kByChannel)));
}

HWY_INLINE hn::Vec<hn::ScalableTag<uint64_t>> in_pairs(V32 v) {
  return hn::BitCast(hn::ScalableTag<uint64_t>(), v);
}

/// Samples as many pixels as a vector has 32 bits.
HWY_INLINE void sample_vector(const uint8_t* origin, const uint32_t* offsets, size_t pitch, V32 entry,
                              size_t at, Samples& samples) {
  const U32 d;
  const hn::ScalableTag<uint64_t> d64;
  const V32 q0 = fetch_quads(origin, offsets, pitch), q1 = fetch_quads(origin, offsets + 1, pitch);
  const V32 q2 = fetch_quads(origin, offsets + 2, pitch), q3 = fetch_quads(origin, offsets + 3, pitch);
  const auto bg01 = in_pairs(hn::InterleaveLower(d, q0, q1)), bg23 = in_pairs(hn::InterleaveLower(d, q2, q3));
  const auto r01 = in_pairs(hn::InterleaveUpper(d, q0, q1)), r23 = in_pairs(hn::InterleaveUpper(d, q2, q3));
  const BilinearWeights weights(hn::And(entry, hn::Set(d, 0x001F001F)));
  store_channels(interpolate(hn::BitCast(U8(), hn::InterleaveLower(d64, bg01, bg23)), weights),
                 interpolate(hn::BitCast(U8(), hn::InterleaveUpper(d64, bg01, bg23)), weights),
                 interpolate(hn::BitCast(U8(), hn::InterleaveLower(d64, r01, r23)), weights), at, samples);
}

#endif
}  // namespace svchain::synthesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
