#pragma once
// The colours of the pictures: one for each core.

#include <array>
#include <cstddef>

namespace svchain {

struct Colour {
  const char* lane;  // behind the links
  const char* box;   // of a link
  const char* edge;  // of its border
};

inline const Colour& colour_of_core(int core) {
  static constexpr std::array<Colour, 8> kColours = {{
      {"#f1f6fc", "#cfe2f7", "#4a7fb5"},  // blue
      {"#fdf6ec", "#fbe3bf", "#c58a2c"},  // amber
      {"#f1f9f1", "#cdeacb", "#4f9a4d"},  // green
      {"#fbf1f4", "#f6d2dc", "#bb5a78"},  // rose
      {"#f6f2fb", "#e0d3f4", "#7d5fb2"},  // violet
      {"#eef9f8", "#c6ebe7", "#3b938b"},  // teal
      {"#fbfae8", "#f0ebb0", "#97902a"},  // olive
      {"#f5f5f5", "#dedede", "#747474"},  // grey
  }};
  return kColours[static_cast<size_t>(core) % kColours.size()];
}

}  // namespace svchain
