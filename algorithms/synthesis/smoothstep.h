#pragma once
// The cubic 3t^2 - 2t^3 from 0 to 1, flat at both ends and beyond them.

#include <algorithm>

namespace svchain::synthesis {

inline double smoothstep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace svchain::synthesis
