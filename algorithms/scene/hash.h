#pragma once
// Random numbers that depend on nothing but their arguments, so that every frame can be made anew, in any
// order.

#include <cstdint>

namespace svchain::scene {

/// A well mixed 64-bit word (the finaliser of SplitMix64, Steele et al. 2014).
constexpr uint64_t hash(uint64_t a) {
  a += 0x9e3779b97f4a7c15ull;
  a = (a ^ (a >> 30)) * 0xbf58476d1ce4e5b9ull;
  a = (a ^ (a >> 27)) * 0x94d049bb133111ebull;
  return a ^ (a >> 31);
}

template <class... More>
constexpr uint64_t hash(uint64_t a, More... more) {
  return hash(a ^ hash(static_cast<uint64_t>(more)...));
}

/// 0 (inclusive) to 1 (exclusive).
constexpr double unit(uint64_t word) {
  return static_cast<double>(word >> 11) * 0x1.0p-53;
}

}  // namespace svchain::scene
