#pragma once
// The bowl and the car in its middle, rendered by OpenGL ES 3: what bowl::ViewpointLut, synthesis::synthesize
// and car::CarPicture make on the CPU, within a level or two. Cameras' frames go up as they are, with the
// mesh table's triangles drawn from any viewpoint; the picture is read back before render() returns.
// Borrows the context, which has to live longer. Any thread, one at a time: every call takes the context into
// use and lets go of it. All calls throw gl::GlLost where the context is lost (then make both anew), and
// std::runtime_error where OpenGL ES refuses.

#include <Eigen/Core>
#include <memory>
#include <span>

#include "algorithms/bowl/mesh_table.h"
#include "algorithms/bowl/viewpoint.h"
#include "algorithms/car/car_model.h"
#include "algorithms/colour/picture.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/gl/gl_context.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::gl {

/// Who draws the car: OpenGL, or car::CarPicture while OpenGL draws the bowl.
enum class CarDrawnBy { kGl, kCpu };

class BowlRenderer {
 public:
  /// Of pictures of this size.
  BowlRenderer(const GlContext& context, const Eigen::Vector2i& size_px);
  ~BowlRenderer();

  /// Copies what it needs of a mesh table and the rig it was made for. Throws std::invalid_argument where it
  /// was made for another rig.
  void set_mesh(const bowl::MeshTable& mesh, const geometry::Rig& rig);
  /// Copies the model, as car::CarPicture takes it. One without triangles is no car, as before the first. If
  /// nothing is said OpenGL draws it where it has a GPU: on a CPU it takes three times as long as CarPicture.
  void set_car(const car::CarModel& model, const geometry::Vehicle& vehicle);
  void set_car(const car::CarModel& model, const geometry::Vehicle& vehicle, CarDrawnBy by);

  /// Four frames of the sizes that the mesh table was made for, each in its own format, rows of any pitch; an
  /// empty one is a black picture. `viewpoint` is free of faults; `car_opacity` is 0 (no car) to 1. `bgr` has
  /// the renderer's size and is written completely. Throws std::invalid_argument, before anything is drawn,
  /// where that is not so or there is no mesh table. The renderer itself allocates nothing where formats and
  /// sizes are those of the frame before and the car is not larger in the picture; the driver may.
  void render(std::span<const colour::Picture> frames, const synthesis::ToneMapping& tone_mapping,
              const bowl::Viewpoint& viewpoint, float car_opacity, const colour::Picture& bgr);

  /// render() is these three in a row; apart they are for who measures what each of them takes. Drawing may
  /// go on after draw() has returned; what was refused there is told by read_back().
  void upload(std::span<const colour::Picture> frames);
  void draw(const synthesis::ToneMapping& tone_mapping, const bowl::Viewpoint& viewpoint, float car_opacity);
  void read_back(const colour::Picture& bgr);

 private:
  struct Parts;

  void check(std::span<const colour::Picture> frames) const;
  void check(const colour::Picture& bgr) const;

  const GlContext& context_;
  Eigen::Vector2i size_px_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace svchain::gl
