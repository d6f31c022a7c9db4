#pragma once
// The photometric LUT of the paper: what every value of every channel of every camera becomes. Plain,
// trivially copyable value, because it travels between cores in a pool buffer.

#include <array>
#include <cstdint>
#include <type_traits>

namespace svchain::synthesis {

inline constexpr int kMaxCameras = 8;
inline constexpr int kChannels = 3;  // b, g, r

struct ToneMapping {
  using Curve = std::array<uint8_t, 256>;

  std::array<std::array<Curve, kChannels>, kMaxCameras> curves;  // [camera][channel][value]

  /// Every value stays as it is.
  static ToneMapping identity();
};

static_assert(std::is_trivially_copyable_v<ToneMapping> && sizeof(ToneMapping) == 8 * 3 * 256);

}  // namespace svchain::synthesis
