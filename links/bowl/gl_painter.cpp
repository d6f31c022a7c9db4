#include "links/bowl/gl_painter.h"

#include <stdexcept>

namespace svchain {

GlPainter::GlPainter(const Eigen::Vector2i& size_px) : size_px_(size_px) {
  begin();
}

/// All that a context has, from what is kept here. There is no renderer where that fails.
void GlPainter::begin() {
  renderer_.reset();
  context_ = std::make_unique<gl::GlContext>();
  auto renderer = std::make_unique<gl::BowlRenderer>(*context_, size_px_);
  if (car_) renderer->set_car(car_->model, car_->vehicle);
  if (world_) renderer->set_mesh(world_->mesh, world_->rig);
  renderer_ = std::move(renderer);
}

void GlPainter::begin_anew(const gl::GlLost& lost) {
  ++times_lost_;
  try {
    begin();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(lost.what()) + "; a new one: " + error.what());
  }
}

template <class Work>
void GlPainter::do_or_begin_anew(const Work& work) {
  if (!renderer_) begin();
  try {
    work();
  } catch (const gl::GlLost& lost) {
    begin_anew(lost);
    work();
  }
}

void GlPainter::set_car(car::CarModel model, const geometry::Vehicle& vehicle, float opacity) {
  car_ = {std::move(model), vehicle, opacity};
  renderer_->set_car(car_->model, car_->vehicle);
}

void GlPainter::set_mesh(const bowl::MeshTable& mesh, const geometry::Rig& rig) {
  world_ = {mesh, rig};
  do_or_begin_anew([&] { renderer_->set_mesh(mesh, rig); });
}

void GlPainter::paint(const BowlPainter::Frames& frames, const synthesis::ToneMapping& tone_mapping,
                      const bowl::Viewpoint& viewpoint, const colour::Picture& bgr) {
  do_or_begin_anew(
      [&] { renderer_->render(frames, tone_mapping, viewpoint, car_ ? car_->opacity : 0, bgr); });
}

}  // namespace svchain
