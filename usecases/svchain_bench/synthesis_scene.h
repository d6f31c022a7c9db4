#pragma once
// What synthesis and those it is measured against read and write: frames of the parked car, its LUT, curves
// and a composite, made so that all of them agree but for rounding. The frames are there several times over,
// more than caches hold: in a stream a camera's frames come from memory, while LUTs, maps and the like stay
// near. Frames, composite and LUT lie in memory as a chain's pools have it. One thread calls it.

#include <array>
#include <cstddef>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/synthesize.h"
#include "framework/chain/workers.h"
#include "usecases/svchain_bench/pool_memory.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

class SynthesisScene {
 public:
  using Pictures = std::array<colour::Picture, 4>;
  /// The same four pictures in both formats, as OpenCV's way and as ours take them.
  struct Set {
    std::array<cv::Mat, 4> bgr, nv12;
    Pictures bgr_pictures, nv12_pictures;
  };

  explicit SynthesisScene(const ParkedCar& car);
  SynthesisScene(const SynthesisScene&) = delete;
  SynthesisScene& operator=(const SynthesisScene&) = delete;

  const synthesis::GeometricLut& lut() const { return *lut_; }
  void synthesize(const Pictures& frames, synthesis::Kernel kernel);
  /// In parts, as the link does it where its core has several CPUs.
  void synthesize(const Pictures& frames, synthesis::Kernel kernel, Workers& workers);

  synthesis::ToneMapping curves;
  std::vector<Set> sets;
  cv::Mat composite;

 private:
  Set set_of(const std::array<cv::Mat, 4>& pictures);

  PoolMemory memory_;
  std::vector<std::byte> statistics_memory_;
  std::unique_ptr<synthesis::GeometricLut> lut_;
  synthesis::OverlapStatistics* statistics_;  // in its memory
};

}  // namespace svchain::bench
