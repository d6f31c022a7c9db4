#include "links/bowl/gl_painter.h"

namespace svchain {

GlPainter::GlPainter(const Eigen::Vector2i& size_px) : size_px_(size_px) {
  begin();
}

/// All that a context has, from what is kept here.
void GlPainter::begin() {
  renderer_.reset();
  context_ = std::make_unique<gl::GlContext>();
  renderer_ = std::make_unique<gl::BowlRenderer>(*context_, size_px_);
  if (car_) renderer_->set_car(car_->model, car_->vehicle);
  if (world_) renderer_->set_mesh(world_->mesh, world_->rig);
}

void GlPainter::set_car(car::CarModel model, const geometry::Vehicle& vehicle, float opacity) {
  car_ = {std::move(model), vehicle, opacity};
  renderer_->set_car(car_->model, car_->vehicle);
}

void GlPainter::set_mesh(const bowl::MeshTable& mesh, const geometry::Rig& rig) {
  world_ = {mesh, rig};
  try {
    renderer_->set_mesh(mesh, rig);
  } catch (const gl::GlLost&) {
    ++times_lost_;
    begin();
  }
}

void GlPainter::paint(const BowlPainter::Frames& frames, const synthesis::ToneMapping& tone_mapping,
                      const bowl::Viewpoint& viewpoint, const colour::Picture& bgr) {
  const float opacity = car_ ? car_->opacity : 0;
  try {
    renderer_->render(frames, tone_mapping, viewpoint, opacity, bgr);
  } catch (const gl::GlLost&) {
    ++times_lost_;
    begin();
    renderer_->render(frames, tone_mapping, viewpoint, opacity, bgr);
  }
}

}  // namespace svchain
