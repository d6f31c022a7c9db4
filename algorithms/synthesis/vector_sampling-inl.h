// Sampling of frames in vectors; included once for each set of instructions (vector_stages.cpp).
#if defined(SVCHAIN_VECTOR_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SVCHAIN_VECTOR_SAMPLING_INL_H
#undef SVCHAIN_VECTOR_SAMPLING_INL_H
#else
#define SVCHAIN_VECTOR_SAMPLING_INL_H
#endif

#include "algorithms/synthesis/vector_pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace svchain::synthesis::HWY_NAMESPACE {
#if HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR

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

/// Upper and lower neighbours of a pixel, 8 bytes each.
HWY_INLINE hn::Vec<hn::Full128<uint8_t>> fetch_pixel(const uint8_t* upper, size_t pitch) {
#if HWY_ARCH_X86  // GCC does not find this load of a half by itself
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(upper));
  return hn::Vec<hn::Full128<uint8_t>>{
      _mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(low), reinterpret_cast<const __m64*>(upper + pitch)))};
#else
  const hn::Full64<uint8_t> d;
  return hn::Combine(hn::Full128<uint8_t>(), hn::LoadU(d, upper + pitch), hn::LoadU(d, upper));
#endif
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

/// Whole pixels of entries, x in the low and y in the high half.
HWY_INLINE V16 whole_pixels(V32 entry) {
  return hn::BitCast(I16(), hn::ShiftRight<kFractionBits>(hn::BitCast(U16(), entry)));
}
/// Where pixels begin that are `step` bytes wide.
HWY_INLINE V32 offsets_of(V16 pixels, size_t pitch, uint32_t step) {
  const V32 factors = hn::Set(U32(), static_cast<uint32_t>(pitch) << 16 | step);
  return hn::BitCast(U32(), products_summed(pixels, hn::BitCast(I16(), factors)));
}

HWY_INLINE hn::Vec<hn::ScalableTag<uint64_t>> in_pairs(V32 v) {
  return hn::BitCast(hn::ScalableTag<uint64_t>(), v);
}

/// All offsets come first: read back at once they would be taken out of the vector one by one, which is
/// slower than loads.
void sample_bgr(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const U32 d;
  const hn::ScalableTag<uint64_t> d64;
  alignas(kLargestVector) uint32_t offsets[kBlockPixels];
  for (size_t i = 0; i < count; i += hn::Lanes(d))
    hn::Store(offsets_of(whole_pixels(load_entries(entries + i, count - i)), box.pitch, kChannels), d,
              offsets + i);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V32 q0 = fetch_quads(box.origin, offsets + i, box.pitch);
    const V32 q1 = fetch_quads(box.origin, offsets + i + 1, box.pitch);
    const V32 q2 = fetch_quads(box.origin, offsets + i + 2, box.pitch);
    const V32 q3 = fetch_quads(box.origin, offsets + i + 3, box.pitch);
    const auto bg01 = in_pairs(hn::InterleaveLower(d, q0, q1)),
               bg23 = in_pairs(hn::InterleaveLower(d, q2, q3));
    const auto r01 = in_pairs(hn::InterleaveUpper(d, q0, q1)), r23 = in_pairs(hn::InterleaveUpper(d, q2, q3));
    const V32 entry = load_entries(entries + i, count - i);
    const BilinearWeights weights(hn::And(entry, hn::Set(d, 0x001F001F)));
    store_channels(interpolate(hn::BitCast(U8(), hn::InterleaveLower(d64, bg01, bg23)), weights),
                   interpolate(hn::BitCast(U8(), hn::InterleaveUpper(d64, bg01, bg23)), weights),
                   interpolate(hn::BitCast(U8(), hn::InterleaveLower(d64, r01, r23)), weights), i, samples);
  }
}

/// So many pixels of NV12 at a time, so that what is fetched stays near.
constexpr size_t kNv12Pixels = 320;
static_assert(kBlockPixels % kNv12Pixels == 0 && kNv12Pixels % kLargestVector == 0);

/// The neighbours of pixels in NV12, as they come: p00 p10 p01 p11 of Y, and u v u v of the upper and the
/// lower groups. Where both neighbours are of one group, the second of a pair is not its own.
struct Nv12Fetch {
  alignas(kLargestVector) uint32_t luma_at[kNv12Pixels], upper_at[kNv12Pixels], lower_at[kNv12Pixels];
  alignas(kLargestVector) uint32_t luma[kNv12Pixels];
  alignas(kLargestVector) uint64_t chroma[kNv12Pixels];
};

template <class T>
HWY_INLINE T load_as(const uint8_t* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

HWY_INLINE void find_nv12(const FrameBox& box, const uint32_t* entries, size_t count, Nv12Fetch& fetch) {
  const U32 d;
  const auto in_group = hn::BitCast(I16(), hn::Set(d, make_entry(box.odd_x, box.odd_y)));
  const auto one_below = hn::BitCast(I16(), hn::Set(d, make_entry(0, 1)));
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V16 pixels = whole_pixels(load_entries(entries + i, count - i));
    const V16 upper = hn::Add(pixels, in_group), lower = hn::Add(upper, one_below);
    hn::Store(offsets_of(pixels, box.pitch, 1), d, fetch.luma_at + i);
    hn::Store(offsets_of(hn::ShiftRight<1>(upper), box.pitch, 2), d, fetch.upper_at + i);
    hn::Store(offsets_of(hn::ShiftRight<1>(lower), box.pitch, 2), d, fetch.lower_at + i);
  }
}

HWY_INLINE void fetch_nv12(const FrameBox& box, size_t count, Nv12Fetch& fetch) {
  const uint8_t* const above = box.origin;
  const uint8_t* const below = box.origin + box.pitch;
  const uint8_t* const chroma = box.chroma;
  for (size_t i = 0; i < count; ++i) {
    fetch.luma[i] = load_as<uint16_t>(above + fetch.luma_at[i]) |
                    uint32_t{load_as<uint16_t>(below + fetch.luma_at[i])} << 16;
    fetch.chroma[i] = load_as<uint32_t>(chroma + fetch.upper_at[i]) |
                      uint64_t{load_as<uint32_t>(chroma + fetch.lower_at[i])} << 32;
  }
  for (size_t i = count; i % hn::Lanes(U32()) != 0; ++i) fetch.luma[i] = 0, fetch.chroma[i] = 0;
}

/// bgr_of (colour/yuv.h) of samples that are Y, U and V as yet.
HWY_INLINE void turn_to_bgr(const colour::YuvMatrix& m, size_t count, Samples& samples) {
  const I16 d;
  const hn::Rebind<uint8_t, I16> d8;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V16 y = hn::Sub(hn::PromoteTo(d, hn::Load(d8, samples.channel[0] + i)), hn::Set(d, m.offset));
    const V16 u = hn::Sub(hn::PromoteTo(d, hn::Load(d8, samples.channel[1] + i)), hn::Set(d, 128));
    const V16 v = hn::Sub(hn::PromoteTo(d, hn::Load(d8, samples.channel[2] + i)), hn::Set(d, 128));
    const V16 du = hn::ShiftLeft<7>(u), dv = hn::ShiftLeft<7>(v);
    const V16 luma = hn::Add(hn::MulFixedPoint15(hn::ShiftLeft<7>(y), hn::Set(d, m.of_y)), hn::Set(d, 16));
    const V16 b = hn::Add(luma, hn::MulFixedPoint15(du, hn::Set(d, m.b_of_u)));
    const V16 g = hn::Add(luma, hn::Add(hn::MulFixedPoint15(du, hn::Set(d, m.g_of_u)),
                                        hn::MulFixedPoint15(dv, hn::Set(d, m.g_of_v))));
    const V16 r = hn::Add(luma, hn::MulFixedPoint15(dv, hn::Set(d, m.r_of_v)));
    hn::Store(hn::DemoteTo(d8, hn::ShiftRight<5>(b)), d8, samples.channel[0] + i);
    hn::Store(hn::DemoteTo(d8, hn::ShiftRight<5>(g)), d8, samples.channel[1] + i);
    hn::Store(hn::DemoteTo(d8, hn::ShiftRight<5>(r)), d8, samples.channel[2] + i);
  }
}

/// u v u v of two rows to p00 p10 p01 p11 of U, then of V.
HWY_INLINE V32 chroma_quads(const uint64_t* from) {
  alignas(16) static constexpr uint8_t kByChannel[16] = {0, 2,  4,  6,  1, 3,  5,  7,
                                                         8, 10, 12, 14, 9, 11, 13, 15};
  const hn::ScalableTag<uint64_t> d;
  const V8 bytes = hn::BitCast(U8(), hn::Load(d, from));
  return hn::BitCast(U32(), hn::TableLookupBytes(bytes, hn::LoadDup128(U8(), kByChannel)));
}

/// Where both neighbours are of one group the fraction is 0, which gives that group's value.
HWY_INLINE V32 chroma_fractions(V32 entry, V32 odd) {
  const U32 d;
  const hn::ScalableTag<uint16_t> d16;
  const auto parity = hn::And(hn::BitCast(d16, hn::Add(entry, odd)), hn::Set(d16, kOnePixel));
  const auto apart = hn::VecFromMask(d16, hn::Eq(parity, hn::Set(d16, kOnePixel)));
  return hn::And(hn::And(entry, hn::Set(d, 0x001F001F)), hn::BitCast(d, apart));
}

HWY_INLINE void interpolate_nv12(const Nv12Fetch& fetch, V32 odd, const uint32_t* entries, size_t count,
                                 size_t at, Samples& samples) {
  const U32 d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V32 entry = load_entries(entries + i, count - i);
    const V32 first = chroma_quads(fetch.chroma + i);
    const V32 second = chroma_quads(fetch.chroma + i + hn::Lanes(d) / 2);
    const BilinearWeights of_luma(hn::And(entry, hn::Set(d, 0x001F001F)));
    const BilinearWeights of_chroma(chroma_fractions(entry, odd));
    store_channels(interpolate(hn::BitCast(U8(), hn::Load(d, fetch.luma + i)), of_luma),
                   interpolate(hn::BitCast(U8(), hn::ConcatEven(d, second, first)), of_chroma),
                   interpolate(hn::BitCast(U8(), hn::ConcatOdd(d, second, first)), of_chroma), at + i,
                   samples);
  }
}

void sample_nv12(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const V32 odd = hn::Set(U32(), make_entry(box.odd_x * kOnePixel, box.odd_y * kOnePixel));
  Nv12Fetch fetch;
  for (size_t at = 0; at < count; at += kNv12Pixels) {
    const size_t pixels = count - at < kNv12Pixels ? count - at : kNv12Pixels;
    find_nv12(box, entries + at, pixels, fetch);
    fetch_nv12(box, pixels, fetch);
    interpolate_nv12(fetch, odd, entries + at, pixels, at, samples);
  }
  turn_to_bgr(*box.matrix, count, samples);
}

/// Reading 8 bytes where 6 are wanted must end within the frame; rows further apart than 16 bits say, and
/// YUYV, have no vectors of their own.
void sample(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const bool vectors = !box.empty() && !box.reaches_end && box.pitch <= 0x7FFF;
  if (vectors && box.format == colour::PixelFormat::kBgr8) return sample_bgr(box, entries, count, samples);
  if (vectors && box.format == colour::PixelFormat::kNv12) return sample_nv12(box, entries, count, samples);
  kPortableStages.sample(box, entries, count, samples);
}

inline constexpr Stages kStages = {sample, undo_falloff, add, tone_tables, tone_map, blend, pack};

#endif
}  // namespace svchain::synthesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
