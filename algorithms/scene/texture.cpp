#include "algorithms/scene/texture.h"

#include <algorithm>

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

Eigen::Vector3d sample(const Texture& texture, double u, double v) {
  u = std::clamp(u, 0.0, texture.width - 1.001);
  v = std::clamp(v, 0.0, texture.height - 1.001);
  const int x = static_cast<int>(u);
  const int y = static_cast<int>(v);
  const double a = u - x;
  const double b = v - y;
  const auto at = [&](int i, int j) {
    const uint32_t t = texture.row(j)[i];
    return Eigen::Vector3d(t & 255, t >> 8 & 255, t >> 16 & 255);
  };
  return (1 - b) * ((1 - a) * at(x, y) + a * at(x + 1, y)) +
         b * ((1 - a) * at(x, y + 1) + a * at(x + 1, y + 1));
}

}  // namespace svchain::scene
