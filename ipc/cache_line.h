#pragma once
// What two threads write lies on cache lines of its own.

#include <cstddef>

namespace svchain::ipc {

constexpr size_t kCacheLine = 64;

constexpr size_t rounded_to_cache_line(size_t bytes) {
  return (bytes + kCacheLine - 1) / kCacheLine * kCacheLine;
}

}  // namespace svchain::ipc
