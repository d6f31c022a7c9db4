// One source, compiled once for each set of instructions.
#define HWY_DISABLED_TARGETS (~(HWY_SSE4 | HWY_AVX2 | HWY_AVX3 | HWY_NEON | HWY_EMU128 | HWY_SCALAR))
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/car/blend_row.cpp"
#include "algorithms/car/blend_row.h"

#include <hwy/foreach_target.h>
// Behind the above:
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace svchain::car::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::CappedTag<uint16_t, 16>;
using Bytes = hn::Rebind<uint8_t, Words>;
using V = hn::Vec<Bytes>;

/// a b / 255, rounded.
HWY_INLINE V share(V a, V b) {
  const Words w;
  const auto product = hn::Add(hn::Mul(hn::PromoteTo(w, a), hn::PromoteTo(w, b)), hn::Set(w, 128));
  const auto whole = hn::ShiftRight<8>(hn::Add(product, hn::ShiftRight<8>(product)));
  return hn::DemoteTo(Bytes(), hn::BitCast(hn::RebindToSigned<Words>(), whole));
}

void blend_row(const uint8_t* car, size_t count, uint8_t* bgr) {
  const Bytes d;
  size_t k = 0;
  for (; k + hn::Lanes(d) <= count; k += hn::Lanes(d)) {
    V b, g, r, alpha, under_b, under_g, under_r;
    hn::LoadInterleaved4(d, car + 4 * k, b, g, r, alpha);
    if (hn::AllTrue(d, hn::Eq(alpha, hn::Zero(d)))) continue;
    hn::LoadInterleaved3(d, bgr + 3 * k, under_b, under_g, under_r);
    const V rest = hn::Xor(alpha, hn::Set(d, 255));
    hn::StoreInterleaved3(hn::Add(b, share(under_b, rest)), hn::Add(g, share(under_g, rest)),
                          hn::Add(r, share(under_r, rest)), d, bgr + 3 * k);
  }
  for (; k < count; ++k)
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t kept = bgr[3 * k + c] * (255u - car[4 * k + 3]) + 128;
      bgr[3 * k + c] = static_cast<uint8_t>(car[4 * k + c] + ((kept + (kept >> 8)) >> 8));
    }
}

}  // namespace svchain::car::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace svchain::car {

HWY_EXPORT(blend_row);

void blend_row(const uint8_t* car, size_t count, uint8_t* bgr) {
  HWY_DYNAMIC_DISPATCH(blend_row)(car, count, bgr);
}

}  // namespace svchain::car
#endif
