#pragma once
// Curves that follow no rule, the same in every test: what goes wrong in a kernel shows.

#include <random>

#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::testing {

inline synthesis::ToneMapping random_tone_mapping() {
  std::mt19937 random(5);
  synthesis::ToneMapping mapping{};
  for (auto& camera : mapping.curves)
    for (auto& curve : camera)
      for (uint8_t& value : curve) value = static_cast<uint8_t>(random());
  return mapping;
}

}  // namespace svchain::testing
