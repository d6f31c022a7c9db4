#include "algorithms/gl/bowl_renderer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/car/car_picture.h"
#include "algorithms/gl/bowl_pass.h"
#include "algorithms/gl/camera_textures.h"
#include "algorithms/gl/car_layer.h"
#include "algorithms/gl/packed_bgr.h"
#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/lut_header.h"

namespace svchain::gl {
namespace {

using colour::Picture;
using colour::PixelFormat;
using Size = std::array<int32_t, 2>;

[[noreturn]] void refuse(const std::string& message) {
  throw std::invalid_argument("GL renderer: " + message);
}

void require(bool condition, const std::string& message) {
  if (!condition) refuse(message);
}

std::string text(const Size& size) {
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " px";
}

/// As synthesis has it, for the falloff.
std::array<Eigen::Vector2f, kCameraCount> lens_centres_px(const geometry::Rig& rig) {
  synthesis::LutHeader header{};
  fill_header(header, rig, {1, 1});
  std::array<Eigen::Vector2f, kCameraCount> centres;
  for (size_t c = 0; c < kCameraCount; ++c)
    centres[c] = Eigen::Vector2i(header.lens_centre[c][0], header.lens_centre[c][1]).cast<float>() /
                 float{synthesis::kOnePixel};
  return centres;
}

/// The car by the CPU, painted anew only where it is seen from elsewhere.
class PaintedCar {
 public:
  PaintedCar(const car::CarModel& model, const geometry::Vehicle& vehicle) : picture_(model, vehicle) {}

  void show_from(const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px, float opacity) {
    if (opacity == opacity_ && viewpoint == viewpoint_) return;
    picture_.render(car::seen_from(viewpoint, size_px), opacity);
    viewpoint_ = viewpoint;
    opacity_ = opacity;
  }
  void lay_over(const Picture& bgr) const {
    cv::Mat picture(bgr.height_px, bgr.width_px, CV_8UC3, bgr.pixels, bgr.pitch_bytes);
    picture_.blend_over(picture);
  }

 private:
  car::CarPicture picture_;
  bowl::Viewpoint viewpoint_;
  float opacity_ = 0;  // nothing is painted yet
};

}  // namespace

struct BowlRenderer::Parts {
  explicit Parts(const Eigen::Vector2i& size_px)
      : read_back(static_cast<size_t>(size_px.x()) * static_cast<size_t>(size_px.y())) {
    glBindRenderbuffer(GL_RENDERBUFFER, colour.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size_px.x(), size_px.y());
    glBindFramebuffer(GL_FRAMEBUFFER, picture.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.name());
    require_complete_framebuffer("the picture");
    glDisable(GL_DITHER);
  }

  Renderbuffer colour;
  Framebuffer picture;
  CameraTextures cameras;
  BowlPass bowl;
  std::optional<CarLayer> car;
  std::optional<PaintedCar> painted_car;
  bool painted_car_shown = false;
  std::optional<std::array<Size, kCameraCount>> image_size_px;  // of the mesh table
  std::vector<uint32_t> read_back;
};

BowlRenderer::BowlRenderer(const GlContext& context, const Eigen::Vector2i& size_px)
    : context_(context), size_px_(size_px) {
  require(size_px.minCoeff() > 0, "a picture of " + text({size_px.x(), size_px.y()}));
  const GlContext::Use use(context_);
  GLint most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  require(size_px.maxCoeff() <= most, "a picture of " + text({size_px.x(), size_px.y()}) +
                                          ", and OpenGL ES draws at most " + std::to_string(most) +
                                          " px in each direction");
  parts_ = std::make_unique<Parts>(size_px);
}

BowlRenderer::~BowlRenderer() {
  try {
    const GlContext::Use use(context_);
    parts_.reset();
  } catch (const std::exception&) {
    static_cast<void>(parts_.release());  // what it names goes with the context
  }
}

void BowlRenderer::set_mesh(const bowl::MeshTable& mesh, const geometry::Rig& rig) {
  require(rig.cameras.size() == kCameraCount,
          "expected a rig of four cameras, got " + std::to_string(rig.cameras.size()));
  std::array<Size, kCameraCount> sizes = mesh.header().image_size_px;
  for (size_t c = 0; c < kCameraCount; ++c) {
    const Size size = {rig.cameras[c].image_size_px.x(), rig.cameras[c].image_size_px.y()};
    require(size == sizes[c], "camera \"" + rig.cameras[c].name + "\" has images of " + text(size) +
                                  ", but the mesh table was made for " + text(sizes[c]));
  }
  require(mesh.header().rig_fingerprint == bowl::rig_fingerprint(rig),
          "the mesh table was made for another rig: its fingerprint differs");
  const GlContext::Use use(context_);
  context_.require_not_lost();
  parts_->bowl.set_mesh(mesh, lens_centres_px(rig));
  parts_->image_size_px = sizes;
}

void BowlRenderer::set_car(const car::CarModel& model, const geometry::Vehicle& vehicle) {
  set_car(model, vehicle, context_.on_cpu() ? CarDrawnBy::kCpu : CarDrawnBy::kGl);
}

void BowlRenderer::set_car(const car::CarModel& model, const geometry::Vehicle& vehicle, CarDrawnBy by) {
  const GlContext::Use use(context_);
  context_.require_not_lost();
  parts_->car.reset();
  parts_->painted_car.reset();
  if (model.triangle_count() == 0) return;
  if (by == CarDrawnBy::kGl)
    parts_->car.emplace(model, vehicle, car::bright_day());
  else
    parts_->painted_car.emplace(model, vehicle);
}

/// Texts are made only where they are thrown.
void BowlRenderer::check(std::span<const Picture> frames) const {
  if (!parts_->image_size_px) refuse("no mesh table yet");
  if (frames.size() != kCameraCount) refuse("expected four frames, got " + std::to_string(frames.size()));
  for (size_t c = 0; c < kCameraCount; ++c) {
    if (frames[c].empty()) continue;
    if (frames[c].format == PixelFormat::kBgrx8)
      refuse("the frame of camera " + std::to_string(c) + " is BGRX, which no camera gives");
    const Size got = {frames[c].width_px, frames[c].height_px}, expected = (*parts_->image_size_px)[c];
    if (got != expected)
      refuse("the frame of camera " + std::to_string(c) + " has " + text(got) +
             ", expected the mesh table's " + text(expected));
    if (!has_whole_groups(frames[c].format, got[0], got[1]))
      refuse("the frame of camera " + std::to_string(c) + " has half a group of chroma");
  }
}

void BowlRenderer::check(const Picture& bgr) const {
  const Size got = {bgr.width_px, bgr.height_px}, expected = {size_px_.x(), size_px_.y()};
  if (bgr.empty() || bgr.format != PixelFormat::kBgr8 || got != expected)
    refuse("expected a BGR picture of " + text(expected) + " to draw into, got " + text(got));
}

void BowlRenderer::render(std::span<const Picture> frames, const synthesis::ToneMapping& tone_mapping,
                          const bowl::Viewpoint& viewpoint, float car_opacity, const Picture& bgr) {
  check(bgr);
  const GlContext::Use use(context_);
  upload(frames);
  draw(tone_mapping, viewpoint, car_opacity);
  read_back(bgr);
}

void BowlRenderer::upload(std::span<const Picture> frames) {
  check(frames);
  const GlContext::Use use(context_);
  parts_->cameras.upload(frames);
}

void BowlRenderer::draw(const synthesis::ToneMapping& tone_mapping, const bowl::Viewpoint& viewpoint,
                        float car_opacity) {
  if (!parts_->image_size_px) refuse("no mesh table yet");
  const GlContext::Use use(context_);
  Parts& parts = *parts_;
  car_opacity = std::min(car_opacity, 1.0f);
  const bool with_car = parts.car && car_opacity > 0;
  if (with_car) parts.car->show_from(viewpoint, size_px_);
  glBindFramebuffer(GL_FRAMEBUFFER, parts.picture.name());
  parts.bowl.draw(parts.cameras, tone_mapping, viewpoint, size_px_);
  if (with_car) parts.car->lay_over(car_opacity);
  glFlush();  // the bowl is drawn meanwhile
  parts.painted_car_shown = parts.painted_car && car_opacity > 0;
  if (parts.painted_car_shown) parts.painted_car->show_from(viewpoint, size_px_, car_opacity);
}

void BowlRenderer::read_back(const Picture& bgr) {
  check(bgr);
  const GlContext::Use use(context_);
  Parts& parts = *parts_;
  glBindFramebuffer(GL_FRAMEBUFFER, parts.picture.name());
  glReadPixels(0, 0, size_px_.x(), size_px_.y(), GL_RGBA, GL_UNSIGNED_BYTE, parts.read_back.data());
  const GLenum error = glGetError();
  context_.require_not_lost();
  if (error != GL_NO_ERROR)
    throw std::runtime_error("OpenGL ES: drawing failed with error " + std::to_string(error));
  const auto width = static_cast<size_t>(size_px_.x());
  for (size_t y = 0; y < static_cast<size_t>(size_px_.y()); ++y)
    pack_bgr(&parts.read_back[y * width], width, bgr.pixels + y * bgr.pitch_bytes);
  if (parts.painted_car_shown) parts.painted_car->lay_over(bgr);
}

}  // namespace svchain::gl
