#pragma once
// Memory that a LUT grows in while it is built, and how building fails. Borrows the memory; one thread.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace svchain::synthesis {

inline constexpr size_t kLutContentAlignment = 64;  // a block's content starts on a cache line

[[noreturn]] inline void refuse(const std::string& message) {
  throw std::invalid_argument("geometric LUT: " + message);
}

inline void require_aligned(std::span<std::byte> memory) {
  if (reinterpret_cast<uintptr_t>(memory.data()) % alignof(double) != 0) refuse("the memory is not aligned");
}

/// Grows a LUT at the end of what is written.
class LutWriter {
 public:
  /// Goes on behind the first `used` bytes.
  explicit LutWriter(std::span<std::byte> memory, size_t used = 0) : memory_(memory), used_(used) {}

  /// Zeros.
  template <class T>
  T* append(size_t count) {
    std::byte* const begin = take(count * sizeof(T));
    std::memset(begin, 0, count * sizeof(T));
    return reinterpret_cast<T*>(begin);
  }
  template <class T>
  uint32_t append(const std::vector<T>& items) {
    const auto offset = static_cast<uint32_t>(used_);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(items));
    std::copy(bytes.begin(), bytes.end(), take(bytes.size()));
    return offset;
  }
  void align(size_t alignment) { append<std::byte>((alignment - used_ % alignment) % alignment); }
  uint32_t used() const { return static_cast<uint32_t>(used_); }

 private:
  std::byte* take(size_t bytes) {
    if (bytes > memory_.size() - used_) refuse("the memory does not suffice");
    used_ += bytes;
    return memory_.data() + used_ - bytes;
  }

  std::span<std::byte> memory_;
  size_t used_;
};

}  // namespace svchain::synthesis
