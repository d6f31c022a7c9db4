#pragma once
// A lens maps rays to pixels and back. Rays, not points on an image plane at z = 1: a 180-degree lens sees at
// and behind the image plane. Camera frame: x right, y down, z along the optical axis; pixel (0,0) is the
// centre of the first pixel. Immutable, so any thread may share one.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

namespace svchain::geometry {

class Lens {
 public:
  virtual ~Lens() = default;

  /// Name of the model as rig files spell it.
  virtual std::string model() const = 0;
  /// Largest angle from the optical axis (rad) at which the lens is used.
  virtual double max_angle_rad() const = 0;
  /// Pixel of a ray of any length; nothing for a zero ray or one beyond the largest angle.
  virtual std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& ray) const = 0;
  /// Unit ray of a pixel; nothing where no ray within the largest angle lands there.
  virtual std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel) const = 0;
};

using LensPtr = std::shared_ptr<const Lens>;

}  // namespace svchain::geometry
