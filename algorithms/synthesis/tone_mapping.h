#pragma once
// The photometric LUT of the paper: what every value of every channel of every camera becomes, and before
// that, where it is wanted, how a camera's falloff towards the rim is undone (fixed_point.h, "Radial
// falloff"). Plain, trivially copyable value, because it travels between cores in a pool buffer.

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace svchain::synthesis {

inline constexpr int kMaxCameras = 8;
inline constexpr int kChannels = 3;  // b, g, r

struct ToneMapping {
  using Curve = std::array<uint8_t, 256>;

  std::array<std::array<Curve, kChannels>, kMaxCameras> curves;  // [camera][channel][value]
  std::array<std::array<int32_t, 2>, kMaxCameras> falloff;       // [camera] a1, a2 in 1/4096, within +-4

  /// Every value stays as it is.
  static ToneMapping identity();
  bool has_falloff(size_t camera) const { return falloff[camera][0] != 0 || falloff[camera][1] != 0; }
};

static_assert(std::is_trivially_copyable_v<ToneMapping>);

}  // namespace svchain::synthesis
