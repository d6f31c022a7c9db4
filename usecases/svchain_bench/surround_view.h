#pragma once
// The use case 2dsv_2dsp as the program runs it, and beside it what it is made of: the kernels called one
// after the other. Both work on the same four pictures of the simulated car park, 1280x720 to 880x1080, which
// are in memory before the clock starts, and on all that goes with them: LUT, statistics, tone mapping.
// Throws std::runtime_error where a chain fails.

#include <array>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "algorithms/geometry/view.h"
#include "algorithms/photometric/photometric_alignment.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/overlap_statistics.h"
#include "usecases/svchain_bench/pool_memory.h"

namespace svchain::bench {

/// Four pictures and the rig that took them, in memory and in files of a temporary folder, which goes with
/// the object.
class ParkedCar {
 public:
  ParkedCar();
  ~ParkedCar();
  ParkedCar(const ParkedCar&) = delete;
  ParkedCar& operator=(const ParkedCar&) = delete;

  const geometry::Rig& rig() const { return rig_; }
  const std::array<cv::Mat, 4>& pictures() const { return pictures_; }
  /// As for `--input` and `--rig`.
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path rig_file() const { return folder_ / "rig.json"; }

 private:
  geometry::Rig rig_;
  std::array<cv::Mat, 4> pictures_;
  std::filesystem::path folder_;
};

/// The vehicle's length takes 45 % of the view's height, as in the use case.
geometry::View usual_view(const ParkedCar& car, const Eigen::Vector2i& size_px);

/// Synthesis and photometric alignment, one after the other on one thread, in memory as the chain has it.
class Kernels {
 public:
  Kernels(const ParkedCar& car, const geometry::View& view);
  /// Milliseconds per frame of this many.
  double frame_ms(int frames);
  void synthesize() { synthesize(pictures_); }
  void synthesize(const std::array<cv::Mat, 4>& pictures);
  void align();
  const synthesis::GeometricLut& lut() const { return *lut_; }
  /// Pixels of the composite in which a camera is seen.
  size_t camera_pixels() const;

 private:
  PoolMemory memory_;
  std::array<cv::Mat, 4> pictures_;
  std::vector<std::byte> statistics_memory_;
  std::unique_ptr<synthesis::GeometricLut> lut_;
  std::unique_ptr<photometric::PhotometricAlignment> alignment_;
  cv::Mat composite_;
};

struct UseCase {
  std::string name = "2dsv_2dsp";
  std::vector<std::string> sets = {};  // as for `--set`
};

/// `svchain --usecase NAME --output none`: milliseconds per frame, from the frame by which all is in its
/// stride to the last of this many.
double use_case_frame_ms(const ParkedCar& car, int frames, const UseCase& use_case = {});
/// The same with `--fps`: the 99th percentile of the time from capture to display, ms, start left out.
double use_case_latency_p99_ms(const ParkedCar& car, double fps, int frames);

}  // namespace svchain::bench
