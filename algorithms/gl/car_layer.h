#pragma once
// The car as a viewpoint shows it, kept in a texture of its own as long as the viewpoint stays, and laid over
// the picture. As car::CarPicture does it: four samples a pixel, the nearest opaque surface and before it the
// nearest translucent one. Internal to algorithms/gl; the context is in use.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "algorithms/bowl/viewpoint.h"
#include "algorithms/car/car_model.h"
#include "algorithms/car/lighting.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/gl/gl_objects.h"

namespace svchain::gl {

class CarLayer {
 public:
  /// Throws std::runtime_error where OpenGL cannot draw into textures of floating point.
  CarLayer(const car::CarModel& model, const geometry::Vehicle& vehicle, const car::Light& light);

  /// Draws the car as it is to be laid over a picture of this size, where it is not there already. Into a
  /// framebuffer of its own: another one has to be bound afterwards.
  void show_from(const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px);
  /// Over the picture in the framebuffer bound; `opacity` is 0 to 1.
  void lay_over(float opacity) const;

 private:
  using Rectangle = Eigen::AlignedBox2i;  // of pixels; both corners belong to it
  struct SurfaceUniforms {
    GLint clip_from_vehicle, eye, base_colour, opacity, gloss, metallic;
  };
  struct LayUniforms {
    GLint rectangle, eye, ray, ray_right, ray_down, car_opacity;
  };

  Rectangle extent(const bowl::Perspective& perspective) const;
  void make_room(const Eigen::Vector2i& size_px);
  void draw_surfaces(const bowl::Perspective& perspective);
  void draw_parts(bool opaque) const;

  Program surface_, lay_;
  SurfaceUniforms surface_at_;
  LayUniforms lay_at_;
  VertexArray vertex_array_, no_vertices_;
  Buffer vertices_, indices_;
  std::vector<car::Part> parts_;
  Eigen::AlignedBox3d box_;
  Eigen::Vector2d shadow_reach_;
  double near_m_;
  GLint sample_count_ = 1;
  Framebuffer samples_, pixels_;
  Renderbuffer sample_colours_, sample_depths_;
  std::optional<Texture> surfaces_;  // the pixels' colours
  Eigen::Vector2i room_px_ = {0, 0};
  // Of what is in the pixels:
  bowl::Viewpoint viewpoint_;
  Eigen::Vector2i size_px_ = {0, 0};
  Rectangle rectangle_;
};

}  // namespace svchain::gl
