// Sampling of frames in vectors; included once for each set of instructions (vector_stages.cpp).
#if defined(SVCHAIN_VECTOR_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SVCHAIN_VECTOR_SAMPLING_INL_H
#undef SVCHAIN_VECTOR_SAMPLING_INL_H
#else
#define SVCHAIN_VECTOR_SAMPLING_INL_H
#endif

#include "algorithms/synthesis/avx512_interpolation-inl.h"
#include "algorithms/synthesis/vector_colour-inl.h"
#include "algorithms/synthesis/vector_interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace svchain::synthesis::HWY_NAMESPACE {
#if HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR

/// All offsets come first: read back at once they would be taken out of the vector one by one, which is
/// slower than loads.
void sample_bgr(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const U32 d;
  alignas(kLargestVector) uint32_t offsets[kStagePixels];
  for (size_t i = 0; i < count; i += hn::Lanes(d))
    hn::Store(offsets_of(whole_pixels(load_entries(entries + i, count - i)), box.pitch, kChannels), d,
              offsets + i);
  for (size_t i = 0; i < count; i += hn::Lanes(d))
    sample_vector(box.origin, offsets + i, box.pitch, load_entries(entries + i, count - i), i, samples);
}

/// Reading 8 bytes where 6 are wanted must end within the frame; rows further apart than 16 bits say, and
/// boxes too large to be turned to BGR beforehand, have no vectors of their own.
void sample(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples) {
  const bool vectors = !box.empty() && !box.reaches_end && box.pitch <= 0x7FFF;
  if (vectors && box.format == colour::PixelFormat::kBgr8) return sample_bgr(box, entries, count, samples);
  kPortableStages.sample(box, entries, count, samples);
}

inline constexpr Stages kStages = {turn_to_bgr,
                                   sample,
                                   undo_falloff,
                                   add,
                                   tone_tables,
                                   tone_map,
                                   blend,
                                   kPacking<colour::PixelFormat::kBgr8>,
                                   kPacking<colour::PixelFormat::kBgrx8>};

#endif
}  // namespace svchain::synthesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
