// What samples are made of, from the frame into vectors; included once for each set of instructions.
#if defined(SVCHAIN_VECTOR_FETCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SVCHAIN_VECTOR_FETCH_INL_H
#undef SVCHAIN_VECTOR_FETCH_INL_H
#else
#define SVCHAIN_VECTOR_FETCH_INL_H
#endif

#include "algorithms/synthesis/vector_pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace svchain::synthesis::HWY_NAMESPACE {
#if HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR

/// Whole pixels of entries, x in the low and y in the high half.
HWY_INLINE V16 whole_pixels(V32 entry) {
  return hn::BitCast(I16(), hn::ShiftRight<kFractionBits>(hn::BitCast(U16(), entry)));
}
/// Where pixels begin that are `step` bytes wide.
HWY_INLINE V32 offsets_of(V16 pixels, size_t pitch, uint32_t step) {
  const V32 factors = hn::Set(U32(), static_cast<uint32_t>(pitch) << 16 | step);
  return hn::BitCast(U32(), products_summed(pixels, hn::BitCast(I16(), factors)));
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

#endif
}  // namespace svchain::synthesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
