#pragma once
// The 3D view drawn by the CPU: a LUT of the viewpoint (algorithms/bowl/viewpoint_lut.h), made anew where the
// viewpoint, the rig or the bowl has changed, read through by the kernels of synthesis, and the car laid over
// it. Its core's thread; the work of a call is shared by the CPUs of the core. Allocates where something has
// changed.

#include <array>
#include <optional>
#include <vector>

#include "algorithms/bowl/viewpoint_lut.h"
#include "algorithms/car/car_picture.h"
#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/synthesize.h"
#include "framework/link/call.h"

namespace svchain {

class BowlPainter {
 public:
  static constexpr size_t kCameraCount = 4;
  using Frames = std::array<colour::Picture, kCameraCount>;

  explicit BowlPainter(const Eigen::Vector2i& size_px);

  /// `opacity` is above 0.
  void set_car(car::CarModel model, const geometry::Vehicle& vehicle, float opacity);
  /// Before the first paint().
  void set_world(const geometry::Rig& rig, const bowl::BowlSurface& surface,
                 const synthesis::BlendShape& shape);

  /// `bgr` has the painter's size.
  void paint(const Frames& frames, const synthesis::ToneMapping& tone_mapping,
             const bowl::Viewpoint& viewpoint, cv::Mat& bgr, Call& call);

  uint64_t luts() const { return luts_; }
  uint32_t lut_bytes() const { return lut_ ? lut_->header().bytes : 0; }

 private:
  void look_from(const bowl::Viewpoint& viewpoint, Call& call);

  const synthesis::Kernel kernel_ = synthesis::best_kernel();
  Eigen::Vector2i size_px_;
  std::optional<car::CarPicture> car_;
  float car_opacity_ = 1;
  std::optional<bowl::ViewpointLut> maker_;  // for the world in force
  std::vector<std::byte> memory_;
  std::optional<synthesis::GeometricLut> lut_;  // of the viewpoint shown
  bowl::Viewpoint shown_;
  uint64_t luts_ = 0;
};

}  // namespace svchain
