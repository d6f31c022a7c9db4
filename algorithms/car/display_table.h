#pragma once
// display() of lighting.h in levels of 0..255, in steps finer than an eighth of a level. Any thread.

#include <array>

#include "algorithms/car/lighting.h"

namespace svchain::car {

class DisplayTable {
 public:
  static constexpr float kBrightest = 1.42f;  // is shown as white, and so is all above
  static constexpr int kLast = 4095;

  /// Entry i is for kBrightest (i / kLast)^2: steps grow with the root's slope.
  static const float* levels() {
    static const DisplayTable table;
    return table.levels_.data();
  }

 private:
  DisplayTable() {
    for (size_t i = 0; i < levels_.size(); ++i) {
      const float root = static_cast<float>(i) / kLast;
      levels_[i] = 255 * display(kBrightest * root * root);
    }
  }
  std::array<float, kLast + 1> levels_;
};

}  // namespace svchain::car
