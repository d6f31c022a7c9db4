#pragma once
// Memory that a LUT grows in while it is built, and how building fails. Borrows the memory; one thread.

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

  template <class T>
  T* append(size_t count) {
    const size_t begin = used_;
    if (count * sizeof(T) > memory_.size() - begin) refuse("the memory does not suffice");
    used_ += count * sizeof(T);
    std::memset(memory_.data() + begin, 0, count * sizeof(T));
    return reinterpret_cast<T*>(memory_.data() + begin);
  }
  template <class T>
  uint32_t append(const std::vector<T>& items) {
    const auto offset = static_cast<uint32_t>(used_);
    T* copy = append<T>(items.size());
    if (!items.empty()) std::memcpy(copy, items.data(), items.size() * sizeof(T));
    return offset;
  }
  void align(size_t alignment) { append<std::byte>((alignment - used_ % alignment) % alignment); }
  uint32_t used() const { return static_cast<uint32_t>(used_); }

 private:
  std::span<std::byte> memory_;
  size_t used_;
};

}  // namespace svchain::synthesis
