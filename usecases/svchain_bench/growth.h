#pragma once
// What a frame costs as the composite, the chain and the number of cameras grow. Everything of one kind is
// measured turn and turn about, medians over the rounds. One thread calls it; it takes a minute.

#include <optional>
#include <vector>

#include "usecases/svchain_bench/comparisons.h"

namespace svchain::bench {

/// Synthesis on one thread. The ground's size grows, and one pixel shows as much of it everywhere.
struct SizeCost {
  int width_px = 0, height_px = 0;
  double ms = 0;             // per frame
  double camera_pixels = 0;  // of the composite, where a camera is seen

  double pixels() const { return static_cast<double>(width_px) * height_px; }
  double ns_per_pixel() const { return ms * 1e6 / pixels(); }
  double ns_per_camera_pixel() const { return ms * 1e6 / camera_pixels; }
};

/// A line of links that hand frames on, from the source's to the sink's call.
struct LineCost {
  int links = 0;
  double one_core_ns = 0, two_cores_ns = 0;  // per frame
  std::optional<double> tbb_ns;              // the same number of nodes of a flow graph, one thread
};

/// A line of links that hand sets of so many cameras on, and synthesis of 880x1080 px, whose rigs have four.
struct CameraCost {
  int cameras = 0;
  double one_core_hop_ns = 0, two_cores_hop_ns = 0;
  std::optional<double> synthesis_ms;
};

/// The largest of some costs over the smallest. Throws std::invalid_argument for none.
double spread(const std::vector<double>& costs);

struct Growth {
  std::vector<SizeCost> sizes;
  std::vector<LineCost> lines;
  std::vector<CameraCost> cameras;

  std::vector<double> ns_per_pixel() const;
  std::vector<double> ns_per_camera_pixel() const;
};

Growth measure_growth(const Progress& progress);

}  // namespace svchain::bench
