#pragma once
// The median of any number of values without keeping them: counts in equal bins over a known range, values
// beyond it counting as its ends. Exact to half a bin; on the stack.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace svchain::photometric {

class HistogramMedian {
 public:
  HistogramMedian(double from, double to) : from_(from), bin_((to - from) / kBins) {}

  void add(double value) {
    const double place = std::clamp((value - from_) / bin_, 0.0, kBins - 1.0);
    ++counts_[static_cast<size_t>(place)];
    ++total_;
  }

  /// Middle of the median's bin (of the lower one of two); `from` where nothing was added.
  double median() const {
    if (total_ == 0) return from_;
    const size_t rank = (total_ - 1) / 2;
    size_t below = 0, bin = 0;
    while (below + counts_[bin] <= rank) below += counts_[bin++];
    return from_ + (static_cast<double>(bin) + 0.5) * bin_;
  }

 private:
  static constexpr size_t kBins = 4096;
  double from_;
  double bin_;
  size_t total_ = 0;
  std::array<uint32_t, kBins> counts_ = {};
};

}  // namespace svchain::photometric
