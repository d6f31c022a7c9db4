#pragma once
// Rows of pixels of three bytes from and to pixels of four, one load and one store a pixel. Plain functions,
// any thread.

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace svchain::gl {

inline constexpr size_t kPackedBytes = 3;

/// The fourth byte is anything. Reads not a byte beyond the row.
inline void unpack_bgr(const uint8_t* bgr, size_t count, uint32_t* pixels) {
  if (count == 0) return;
  for (size_t i = 0; i + 1 < count; ++i) std::memcpy(&pixels[i], bgr + kPackedBytes * i, 4);
  std::memcpy(&pixels[count - 1], bgr + kPackedBytes * (count - 1), kPackedBytes);
}

/// The fourth byte is left out. Writes not a byte beyond the row.
inline void pack_bgr(const uint32_t* pixels, size_t count, uint8_t* bgr) {
  if (count == 0) return;
  for (size_t i = 0; i + 1 < count; ++i) std::memcpy(bgr + kPackedBytes * i, &pixels[i], 4);
  std::memcpy(bgr + kPackedBytes * (count - 1), &pixels[count - 1], kPackedBytes);
}

}  // namespace svchain::gl
