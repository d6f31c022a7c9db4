#pragma once
// The 3D view drawn by OpenGL ES 3. A context that gets lost is made anew, once a frame. Its core's thread.

#include <memory>
#include <optional>
#include <string>

#include "algorithms/car/car_model.h"
#include "algorithms/gl/bowl_renderer.h"
#include "links/bowl/bowl_painter.h"

namespace svchain {

class GlPainter {
 public:
  /// Throws std::runtime_error that says why there is no OpenGL ES 3.
  explicit GlPainter(const Eigen::Vector2i& size_px);

  /// `opacity` is above 0.
  void set_car(car::CarModel model, const geometry::Vehicle& vehicle, float opacity);
  /// Before the first paint(). The memory of the mesh table is borrowed until the next.
  void set_mesh(const bowl::MeshTable& mesh, const geometry::Rig& rig);

  /// `bgr` has the painter's size. Throws std::runtime_error where the context is lost and no new one can be
  /// had (the next call tries again), or where OpenGL ES refuses.
  void paint(const BowlPainter::Frames& frames, const synthesis::ToneMapping& tone_mapping,
             const bowl::Viewpoint& viewpoint, const colour::Picture& bgr);

  /// What draws.
  const std::string& name() const { return context_->renderer(); }
  uint64_t times_lost() const { return times_lost_; }

 private:
  struct Car {
    car::CarModel model;
    geometry::Vehicle vehicle;
    float opacity = 0;
  };
  struct World {
    bowl::MeshTable mesh;
    geometry::Rig rig;
  };
  void begin();
  void begin_anew(const gl::GlLost& lost);
  template <class Work>
  void do_or_begin_anew(const Work& work);

  Eigen::Vector2i size_px_;
  std::optional<Car> car_;
  std::optional<World> world_;
  std::unique_ptr<gl::GlContext> context_;
  std::unique_ptr<gl::BowlRenderer> renderer_;  // none where no new context could be had
  uint64_t times_lost_ = 0;
};

}  // namespace svchain
