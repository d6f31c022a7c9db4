#pragma once
// The frames of a scene's cameras. Holds what each pixel looks at (10 to 14 bytes a pixel), made once.
// Immutable: different threads may render at the same time. render() neither allocates nor locks where the
// frame has its size.

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "algorithms/scene/sensor.h"
#include "algorithms/scene/sight_lines.h"
#include "algorithms/scene/solid_finder.h"
#include "algorithms/scene/world.h"

namespace svchain::scene {

class Renderer {
 public:
  explicit Renderer(std::shared_ptr<const World> world);

  /// The frame (BGR, 8 bits) that a camera takes at a time; `frame` picks the noise. `bgr` is given the
  /// camera's size where it has another. The same arguments give the same pixels.
  void render(size_t camera, double time_s, uint64_t frame, cv::Mat& bgr) const;

  const World& world() const { return *world_; }

 private:
  std::shared_ptr<const World> world_;
  std::vector<SightLines> lines_;
  std::vector<SolidFinder> solids_;
  std::vector<Sensor> sensors_;
};

}  // namespace svchain::scene
