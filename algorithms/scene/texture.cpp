#include "algorithms/scene/texture.h"

namespace svchain::scene {

Texture halved(const Texture& fine) {
  constexpr uint32_t kBlueRed = 0x00ff00ff;  // two channels at a time, eight bits of room above each
  Texture coarse(fine.width / 2, fine.height / 2);
  for (int y = 0; y < coarse.height; ++y) {
    const uint32_t* upper = fine.row(2 * y);
    const uint32_t* lower = fine.row(2 * y + 1);
    uint32_t* out = coarse.row(y);
    for (int x = 0; x < coarse.width; ++x) {
      const uint32_t a = upper[2 * x], b = upper[2 * x + 1], c = lower[2 * x], d = lower[2 * x + 1];
      const uint32_t br = (a & kBlueRed) + (b & kBlueRed) + (c & kBlueRed) + (d & kBlueRed) + 0x00020002;
      const uint32_t g = ((a >> 8) & 255) + ((b >> 8) & 255) + ((c >> 8) & 255) + ((d >> 8) & 255) + 2;
      out[x] = ((br >> 2) & kBlueRed) | ((g >> 2) & 255) << 8;
    }
  }
  return coarse;
}

}  // namespace svchain::scene
