#include "links/bowl/bowl_painter.h"

#include <algorithm>
#include <span>

namespace svchain {

namespace {

constexpr int kPartsPerCpu = 4;  // they differ in cost

}  // namespace

BowlPainter::BowlPainter(const Eigen::Vector2i& size_px)
    : size_px_(size_px), memory_(bowl::ViewpointLut::capacity(size_px)) {}

void BowlPainter::set_car(car::CarModel model, const geometry::Vehicle& vehicle, float opacity) {
  car_.emplace(std::move(model), vehicle);
  car_opacity_ = opacity;
  lut_.reset();
}

void BowlPainter::set_world(const geometry::Rig& rig, const bowl::BowlSurface& surface,
                            const synthesis::BlendShape& shape) {
  maker_.emplace(rig, surface, shape);
  lut_.reset();
}

void BowlPainter::paint(const Frames& frames, const synthesis::ToneMapping& tone_mapping,
                        const bowl::Viewpoint& viewpoint, cv::Mat& bgr, Call& call) {
  look_from(viewpoint, call);
  const colour::Picture target = colour::bgr_picture(bgr);
  const int parts = call.cpus() > 1 ? call.cpus() * kPartsPerCpu : 1;
  call.parallel(parts, [&](int i) {
    synthesis::synthesize_part({i, parts}, *lut_, frames, tone_mapping, target, nullptr, kernel_);
  });
  if (car_) car_->blend_over(bgr);
}

/// A viewpoint that stays has its LUT and its picture of the car already.
void BowlPainter::look_from(const bowl::Viewpoint& viewpoint, Call& call) {
  if (lut_ && viewpoint == shown_) return;
  const int parts = std::min(call.cpus() * kPartsPerCpu, bowl::ViewpointLut::kMostParts);
  maker_->begin(viewpoint, size_px_, memory_);
  if (car_) car_->begin(car::seen_from(viewpoint, size_px_), car_opacity_);
  call.parallel(parts, [&](int i) { maker_->make_nodes(i, parts); });
  call.parallel(parts, [&](int i) { maker_->write_blocks(i, parts); });
  if (car_) call.parallel(parts, [&](int i) { car_->draw(i, parts); });
  lut_.emplace(std::span(memory_).first(maker_->finish(parts)));
  shown_ = viewpoint;
  ++luts_;
}

}  // namespace svchain
