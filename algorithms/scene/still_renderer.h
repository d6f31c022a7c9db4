#pragma once
// Pictures of a scene for calibrating and judging: what Renderer shows, but each pixel the mean over its area
// as an optical system with a little blur would give it. Sixteen rays a pixel through the true lens, and a
// Gaussian of 0.5 px. Dozens of times slower than Renderer. Holds the rays (12 bytes a pixel), made once;
// immutable: different threads may render at the same time.

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "algorithms/scene/sensor.h"
#include "algorithms/scene/solids.h"
#include "algorithms/scene/world.h"

namespace svchain::scene {

class StillRenderer {
 public:
  explicit StillRenderer(std::shared_ptr<const World> world);

  /// The frame (BGR, 8 bits) that a camera takes at a time; `frame` picks the noise. The same arguments give
  /// the same pixels. Pixels that the lens does not reach to their corners are black.
  cv::Mat render(size_t camera, double time_s, uint64_t frame) const;

  const World& world() const { return *world_; }

 private:
  std::shared_ptr<const World> world_;
  Solids solids_;
  std::vector<cv::Mat> rays_;  // by camera: CV_32FC3, unit, in the vehicle's frame, of the pixels' corners
  std::vector<std::vector<uint16_t>> falloffs_;
  std::vector<Sensor> sensors_;
};

}  // namespace svchain::scene
