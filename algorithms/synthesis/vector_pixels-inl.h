// The stages behind sampling, in vectors; included once for each set of instructions (vector_stages.cpp).
// Every function gives what its namesake in portable_stages.cpp gives.
#if defined(SVCHAIN_VECTOR_PIXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SVCHAIN_VECTOR_PIXELS_INL_H
#undef SVCHAIN_VECTOR_PIXELS_INL_H
#else
#define SVCHAIN_VECTOR_PIXELS_INL_H
#endif

#include <cstring>
#include <hwy/highway.h>

#include "algorithms/synthesis/stages.h"

HWY_BEFORE_NAMESPACE();
namespace svchain::synthesis::HWY_NAMESPACE {
#if HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR
namespace hn = hwy::HWY_NAMESPACE;

using U8 = hn::ScalableTag<uint8_t>;
using U16 = hn::ScalableTag<uint16_t>;
using I16 = hn::ScalableTag<int16_t>;
using U32 = hn::ScalableTag<uint32_t>;
using I32 = hn::ScalableTag<int32_t>;
using V8 = hn::Vec<U8>;
using V16 = hn::Vec<I16>;
using V32 = hn::Vec<U32>;

/// Sums of the products of neighbouring 16 bits.
HWY_INLINE hn::Vec<I32> products_summed(V16 a, V16 b) {
#if HWY_TARGET == HWY_AVX3_DL
  return hn::Vec<I32>{_mm512_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
  return hn::Vec<I32>{_mm256_madd_epi16(a.raw, b.raw)};
#else
  const I32 d;
  const auto low = [](V16 v) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(hn::BitCast(I32(), v))); };
  const auto high = [](V16 v) { return hn::ShiftRight<16>(hn::BitCast(I32(), v)); };
  return hn::BitCast(d, hn::Add(hn::Mul(low(a), low(b)), hn::Mul(high(a), high(b))));
#endif
}

/// A sum over a plane: of what the samples, their squares and those that are clipped come to.
HWY_INLINE void add_vector(V8 v, hn::Vec<hn::ScalableTag<uint64_t>>& sum, hn::Vec<I32>& squares,
                           size_t& clipped) {
  const U8 d;
  const hn::Half<U8> half;
  sum = hn::Add(sum, hn::SumsOf8(v));
  const V16 lower = hn::PromoteTo(I16(), hn::LowerHalf(half, v));
  const V16 upper = hn::PromoteTo(I16(), hn::UpperHalf(half, v));
  squares = hn::Add(squares, hn::Add(products_summed(lower, lower), products_summed(upper, upper)));
  clipped += hn::CountTrue(d, hn::Lt(hn::Add(v, hn::Set(d, 3)), hn::Set(d, 6)));
}

void add(const Samples& samples, size_t count, BlockSamples& into) {
  const U8 d;
  const hn::ScalableTag<uint64_t> d64;
  const size_t whole = count / hn::Lanes(d) * hn::Lanes(d);
  for (size_t c = 0; c < kChannels; ++c) {
    const uint8_t* plane = samples.channel[c];
    auto sum = hn::Zero(d64);
    auto squares = hn::Zero(I32());
    size_t clipped = 0;
    for (size_t i = 0; i < whole; i += hn::Lanes(d))
      add_vector(hn::Load(d, plane + i), sum, squares, clipped);
    if (whole < count) {  // the rest among zeros, which change no sum, but count as clipped
      alignas(kLargestVector) uint8_t rest[kLargestVector] = {};
      std::memcpy(rest, plane + whole, count - whole);
      add_vector(hn::Load(d, rest), sum, squares, clipped);
      clipped -= hn::Lanes(d) - (count - whole);
    }
    into.sum[c] += static_cast<uint32_t>(hn::GetLane(hn::SumOfLanes(d64, sum)));
    into.sum_of_squares[c] += static_cast<uint32_t>(hn::GetLane(hn::SumOfLanes(I32(), squares)));
    into.clipped[c] += static_cast<uint32_t>(clipped);
  }
}

#if HWY_TARGET == HWY_AVX3_DL
/// The curves as they are: two permutes of bytes reach half of a curve each.
ToneTables tone_tables(const std::array<ToneMapping::Curve, kChannels>& curves) {
  ToneTables tables;
  for (size_t c = 0; c < kChannels; ++c) std::memcpy(tables.channel[c], curves[c].data(), 256);
  return tables;
}

void tone_map(const ToneTables& tables, size_t count, Samples& samples) {
  for (size_t c = 0; c < kChannels; ++c) {
    const uint8_t* table = tables.channel[c];
    const __m512i t0 = _mm512_load_si512(table), t1 = _mm512_load_si512(table + 64);
    const __m512i t2 = _mm512_load_si512(table + 128), t3 = _mm512_load_si512(table + 192);
    for (size_t i = 0; i < count; i += 64) {
      uint8_t* at = samples.channel[c] + i;
      const __m512i v = _mm512_load_si512(at);
      const __m512i below = _mm512_permutex2var_epi8(t0, v, t1), above = _mm512_permutex2var_epi8(t2, v, t3);
      _mm512_store_si512(at, _mm512_mask_blend_epi8(_mm512_movepi8_mask(v), below, above));
    }
  }
}
#else
/// Twice eight tables of sixteen values, for either half of the curve. A lookup by bytes gives 0 for negative
/// indices, so with the index lowered by 16 from table to table, value v gets the exclusive or of the tables
/// 0 to v / 16; hence each is kept as the exclusive or of itself and the one before.
ToneTables tone_tables(const std::array<ToneMapping::Curve, kChannels>& curves) {
  ToneTables tables;
  for (size_t c = 0; c < kChannels; ++c)
    for (size_t v = 0; v < 256; ++v)
      tables.channel[c][v] = static_cast<uint8_t>(curves[c][v] ^ (v % 128 < 16 ? 0 : curves[c][v - 16]));
  return tables;
}

/// Both halves of the curve at once, of which the value's highest bit takes one.
HWY_INLINE V8 look_up(const uint8_t* table, V8 value) {
  const U8 d;
  V8 at = hn::And(value, hn::Set(d, 0x7F)), below = hn::Zero(d), above = hn::Zero(d);
  for (size_t t = 0; t < 128; t += 16) {
#if HWY_ARCH_X86
    const V8 within = at;  // bits 4 to 6 say nothing there
#else
    const V8 within = hn::And(at, hn::Set(d, 0x8F));
#endif
    below = hn::Xor(below, hn::TableLookupBytesOr0(hn::LoadDup128(d, table + t), within));
    above = hn::Xor(above, hn::TableLookupBytesOr0(hn::LoadDup128(d, table + 128 + t), within));
    at = hn::Sub(at, hn::Set(d, 16));
  }
  const auto high = hn::BroadcastSignBit(hn::BitCast(hn::ScalableTag<int8_t>(), value));
  return hn::IfVecThenElse(hn::BitCast(d, high), above, below);
}

void tone_map(const ToneTables& tables, size_t count, Samples& samples) {
  const U8 d;
  for (size_t c = 0; c < kChannels; ++c)
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
      uint8_t* at = samples.channel[c] + i;
      hn::Store(look_up(tables.channel[c], hn::Load(d, at)), d, at);
    }
}
#endif

void blend(Samples& a, const Samples& b, const uint8_t* weights, size_t count) {
  const U16 d;
  const hn::Rebind<uint8_t, U16> d8;
  const auto all = hn::Set(d, 255), half = hn::Set(d, 128);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto weight = hn::PromoteTo(d, hn::Load(d8, weights + i));
    const auto rest = hn::Sub(all, weight);
    for (size_t c = 0; c < kChannels; ++c) {
      const auto of_a = hn::Mul(hn::PromoteTo(d, hn::Load(d8, a.channel[c] + i)), weight);
      const auto of_b = hn::Mul(hn::PromoteTo(d, hn::Load(d8, b.channel[c] + i)), rest);
      const auto t = hn::Add(hn::Add(of_a, of_b), half);
      const auto blended = hn::ShiftRight<8>(hn::Add(t, hn::ShiftRight<8>(t)));
      hn::Store(hn::DemoteTo(d8, hn::BitCast(I16(), blended)), d8, a.channel[c] + i);
    }
  }
}

/// As many pixels as there are lanes, from sample `at`.
template <colour::PixelFormat kFormat, class D>
HWY_INLINE void pack_vector(D d, const Samples& samples, size_t at, uint8_t* to) {
  const auto b = hn::LoadU(d, samples.channel[0] + at), g = hn::LoadU(d, samples.channel[1] + at),
             r = hn::LoadU(d, samples.channel[2] + at);
  if constexpr (kFormat == colour::PixelFormat::kBgrx8)
    hn::StoreInterleaved4(b, g, r, hn::Set(d, 255), d, to);
  else
    hn::StoreInterleaved3(b, g, r, d, to);
}

template <colour::PixelFormat kFormat>
void pack_list(const Samples& samples, size_t count, uint8_t* to) {
  const U8 d;
  for (size_t i = 0; i < count; i += hn::Lanes(d))
    pack_vector<kFormat>(d, samples, i, to + i * colour::bytes_per_px(kFormat));
}

/// The last vector of a row ends with it, and writes some pixels once more.
template <colour::PixelFormat kFormat>
void pack_rows(const Samples& samples, size_t rows, uint8_t* to, size_t pitch) {
  const hn::CappedTag<uint8_t, 32> d;
  const size_t lanes = hn::Lanes(d), last = kBlockSize - lanes;
  for (size_t first = 0; first < rows * kBlockSize; first += kBlockSize, to += pitch) {
    for (size_t x = 0; x < last; x += lanes)
      pack_vector<kFormat>(d, samples, first + x, to + x * colour::bytes_per_px(kFormat));
    pack_vector<kFormat>(d, samples, first + last, to + last * colour::bytes_per_px(kFormat));
  }
}

template <colour::PixelFormat kFormat>
inline constexpr Packing kPacking = {pack_list<kFormat>, pack_rows<kFormat>};

/// RadialScale::length of every distance.
HWY_INLINE hn::Vec<I32> length(const RadialScale& radial, hn::Vec<I32> distance) {
  const I32 d;
  const auto within = hn::Min(hn::Max(distance, hn::Set(d, -radial.limit)), hn::Set(d, radial.limit));
  return hn::ShiftRight<14>(hn::Add(hn::Mul(within, hn::Set(d, radial.scale)), hn::Set(d, 1 << 13)));
}

/// radial_factor at every entry.
HWY_INLINE hn::Vec<I32> factors_at(const Falloff& falloff, V32 entry) {
  const I32 d;
  const auto x = hn::BitCast(d, hn::And(entry, hn::Set(U32(), 0xFFFF)));
  const auto y = hn::BitCast(d, hn::ShiftRight<16>(entry));
  const auto q_x = length(falloff.radial, hn::Sub(x, hn::Set(d, falloff.centre_x)));
  const auto q_y = length(falloff.radial, hn::Sub(y, hn::Set(d, falloff.centre_y)));
  const auto sum = hn::ShiftRight<kRadialBits>(hn::Add(hn::Mul(q_x, q_x), hn::Mul(q_y, q_y)));
  const auto q2 = hn::Min(sum, hn::Set(d, kLargestQ2));
  const auto q4 = hn::ShiftRight<kRadialBits>(hn::Mul(q2, q2));
  const auto terms = hn::Add(hn::Mul(hn::Set(d, falloff.a1), q2), hn::Mul(hn::Set(d, falloff.a2), q4));
  const auto factor = hn::Add(hn::Set(d, kRadialOne), hn::ShiftRight<kRadialBits>(terms));
  return hn::Min(hn::Max(factor, hn::Zero(d)), hn::Set(d, 16 * kRadialOne - 1));
}

/// The entries at the list's end may be fewer than a vector has; the first of the box stands for the others.
HWY_INLINE V32 load_entries(const uint32_t* entries, size_t left) {
  const U32 d;
  if (left >= hn::Lanes(d)) return hn::LoadU(d, entries);
  alignas(kLargestVector) uint32_t rest[kLargestVector / sizeof(uint32_t)] = {};
  std::memcpy(rest, entries, left * sizeof(uint32_t));
  return hn::Load(d, rest);
}

void undo_falloff(const Falloff& falloff, const uint32_t* entries, size_t count, Samples& samples) {
  const I32 d;
  const hn::Rebind<uint8_t, I32> d8;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto factor = factors_at(falloff, load_entries(entries + i, count - i));
    for (auto& channel : samples.channel) {
      const auto value = hn::PromoteTo(d, hn::Load(d8, channel + i));
      const auto product = hn::Add(hn::Mul(value, factor), hn::Set(d, kRadialOne / 2));
      hn::Store(hn::DemoteTo(d8, hn::ShiftRight<kRadialBits>(product)), d8, channel + i);
    }
  }
}

#endif
}  // namespace svchain::synthesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
