#include "algorithms/synthesis/tone_mapping.h"

#include <numeric>

namespace svchain::synthesis {

ToneMapping ToneMapping::identity() {
  ToneMapping mapping{};
  for (auto& camera : mapping.curves)
    for (Curve& curve : camera) std::iota(curve.begin(), curve.end(), uint8_t{0});
  return mapping;
}

}  // namespace svchain::synthesis
