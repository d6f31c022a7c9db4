#pragma once
// What is left between the cameras of a set after a correction, on blocks that the correction was not made
// from: the overlaps' blocks are halved like a checkerboard, each half is corrected by what the other tells.

#include <functional>
#include <optional>
#include <vector>

#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/kernel.h"
#include "algorithms/synthesis/overlap_statistics.h"
#include "usecases/svchain_accuracy/photometric_set.h"

namespace svchain::accuracy {

struct PhotometricFigures {
  std::string method;
  double left = 0;  // mean over all blocks of |a - b|, grey levels at equal mean composite
  std::array<double, 4> overlaps = {};  // the same by overlap: front-right, right-rear, rear-left, left-front
  std::optional<double> from_ideal;     // mean |composite - ideal| of local means after one common curve
  double contrast = 1;                  // standard deviation over mean of the composite, relative to before
};

/// Holds a set's LUT and statistics.
class PhotometricMeasurement {
 public:
  explicit PhotometricMeasurement(const PhotometricSet& set);

  /// Makes a correction from statistics.
  using Method = std::function<synthesis::ToneMapping(synthesis::OverlapStatistics&)>;
  PhotometricFigures measure(const std::string& name, const Method& method) const;

  /// Before correction, the baseline, the true responses inverted without and with falloff (simulated sets),
  /// ours without and with falloff.
  std::vector<PhotometricFigures> measure_all() const;

  cv::Mat composite(const synthesis::ToneMapping& mapping,
                    synthesis::Kernel kernel = synthesis::best_kernel()) const;
  const synthesis::OverlapStatistics& statistics() const { return *statistics_; }

 private:
  struct Half {
    std::vector<std::byte> memory;
    synthesis::OverlapStatistics* statistics;
  };
  Half half(int parity) const;
  int parity_of(uint32_t block) const;
  cv::Scalar composite_mean(const cv::Mat& composite) const;
  double composite_contrast(const cv::Mat& composite) const;
  cv::Mat local_means(const cv::Mat& picture) const;
  double distance_from_ideal(const cv::Mat& composite) const;
  synthesis::ToneMapping baseline(const synthesis::OverlapStatistics& statistics) const;
  synthesis::ToneMapping inverse_responses(bool with_falloff) const;

  const PhotometricSet& set_;
  std::vector<std::byte> lut_memory_, statistics_memory_;
  std::optional<synthesis::GeometricLut> lut_;
  synthesis::OverlapStatistics* statistics_ = nullptr;
  cv::Mat shown_;  // where the composite shows a camera
  cv::Mat before_;
};

}  // namespace svchain::accuracy
