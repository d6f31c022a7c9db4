#pragma once
// Slightly damaged texts, the same ones for the same seed on every machine.

#include <cstdint>
#include <string>
#include <vector>

namespace svchain::testing {

class Mutation {
 public:
  explicit Mutation(uint64_t seed) : state_(seed) {}

  /// One of the texts after one to four small damages: flipped and removed bytes, cuts, doubled and swapped
  /// pieces, tokens from a list of nasty ones, deep nesting.
  std::string next(const std::vector<std::string>& texts);

 private:
  uint64_t random();  // SplitMix64
  size_t below(size_t n) { return n == 0 ? 0 : static_cast<size_t>(random() % n); }
  void damage(std::string& text);

  uint64_t state_;
};

}  // namespace svchain::testing
