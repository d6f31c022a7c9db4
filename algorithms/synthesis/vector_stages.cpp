// One source, compiled once for each set of instructions.
#define HWY_WANT_AVX3_DL
#define HWY_DISABLED_TARGETS (~(HWY_AVX2 | HWY_AVX3_DL | HWY_NEON | HWY_EMU128 | HWY_SCALAR))
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/synthesis/vector_stages.cpp"
#include "algorithms/synthesis/vector_stages.h"

#include <hwy/foreach_target.h>
// Behind the above:
#include <hwy/highway.h>

#include "algorithms/synthesis/vector_pixels-inl.h"
#include "algorithms/synthesis/vector_sampling-inl.h"

#if HWY_ONCE
#include <hwy/targets.h>

namespace svchain::synthesis {
namespace {

/// Asked once: in a virtual machine every question to the processor is a trap.
bool processor_has(int64_t target) {
  static const int64_t kSupported = hwy::SupportedTargets();
  return (kSupported & target) != 0;
}

}  // namespace

const Stages* vector_stages([[maybe_unused]] Kernel kernel) {
#if HWY_TARGETS & HWY_AVX2
  if (kernel == Kernel::kAvx2 && processor_has(HWY_AVX2)) return &N_AVX2::kStages;
#endif
#if HWY_TARGETS & HWY_AVX3_DL
  if (kernel == Kernel::kAvx512 && processor_has(HWY_AVX3_DL)) return &N_AVX3_DL::kStages;
#endif
#if HWY_TARGETS & HWY_NEON
  if (kernel == Kernel::kNeon && processor_has(HWY_NEON)) return &N_NEON::kStages;
#endif
  return nullptr;
}

}  // namespace svchain::synthesis
#endif
