#include "algorithms/gl/car_layer.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "algorithms/car/contact_shadow.h"
#include "algorithms/gl/car_shaders.h"
#include "algorithms/gl/projection.h"

namespace svchain::gl {
namespace {

constexpr int kSurfacesUnit = 0;
constexpr GLint kMostSamples = 4;
constexpr double kNearPerLength = 0.01;  // of the near plane's distance, as car::CarPicture has it
constexpr GLenum kLinear = GL_RGBA16F;   // light is more than white, and dark steps are fine

/// How many a pixel may have, up to kMostSamples.
GLint samples_in(GLenum format) {
  GLint most = 0;  // the first is the largest
  glGetInternalformativ(GL_RENDERBUFFER, format, GL_SAMPLES, 1, &most);
  return std::min(most, kMostSamples);
}

void set(GLint uniform, const Eigen::Vector3f& v) {
  glUniform3f(uniform, v.x(), v.y(), v.z());
}

}  // namespace

CarLayer::CarLayer(const car::CarModel& model, const geometry::Vehicle& vehicle, const car::Light& light)
    : surface_(kCarVertexShader, kCarFragmentShader),
      lay_(kLayVertexShader, kLayFragmentShader),
      surface_at_{
          surface_.uniform("clip_from_vehicle"), surface_.uniform("eye"),   surface_.uniform("base_colour"),
          surface_.uniform("opacity"),           surface_.uniform("gloss"), surface_.uniform("metallic")},
      lay_at_{lay_.uniform("rectangle"), lay_.uniform("eye"),      lay_.uniform("ray"),
              lay_.uniform("ray_right"), lay_.uniform("ray_down"), lay_.uniform("car_opacity")},
      parts_(model.parts),
      box_(car::bounding_box(model).cast<double>()),
      shadow_reach_(car::ContactShadow(vehicle).reach().cast<double>()),
      near_m_(kNearPerLength * box_.sizes().x()) {
  if (!epoxy_has_gl_extension("GL_EXT_color_buffer_half_float") &&
      !epoxy_has_gl_extension("GL_EXT_color_buffer_float"))
    throw std::runtime_error("OpenGL ES: the car needs GL_EXT_color_buffer_half_float");
  sample_count_ = std::min(samples_in(kLinear), samples_in(GL_DEPTH_COMPONENT24));

  using car::Vertex;
  static_assert(sizeof(Vertex) == 6 * sizeof(float));
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(model.vertices.size() * sizeof(Vertex)),
               model.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(model.indices.size() * sizeof(uint32_t)),
               model.indices.data(), GL_STATIC_DRAW);
  for (const GLuint attribute : {0u, 1u}) {  // position, normal
    glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(attribute * 3 * sizeof(float)));
    glEnableVertexAttribArray(attribute);
  }

  surface_.use();
  set(surface_.uniform("to_sun"), light.to_sun);
  set(surface_.uniform("sun"), light.sun);
  set(surface_.uniform("zenith"), light.zenith);
  set(surface_.uniform("horizon"), light.horizon);
  set(surface_.uniform("haze"), light.haze);
  set(surface_.uniform("ground"), light.ground);
  glUniform1f(surface_.uniform("top"), static_cast<float>(box_.max().z()));
  lay_.use();
  glUniform1i(lay_.uniform("surfaces"), kSurfacesUnit);
  glUniform2f(lay_.uniform("half_size"), static_cast<float>(vehicle.length_m / 2),
              static_cast<float>(vehicle.width_m / 2));
  glUniform1f(lay_.uniform("width"), static_cast<float>(vehicle.width_m));
}

void CarLayer::show_from(const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px) {
  if (viewpoint == viewpoint_ && size_px == size_px_) return;
  const bowl::Perspective perspective(viewpoint, size_px);
  viewpoint_ = viewpoint;
  size_px_ = size_px;
  rectangle_ = extent(perspective);
  if (!rectangle_.isEmpty()) draw_surfaces(perspective);
}

/// Around the model's box and the shadow; all of the picture where one of their corners is not clearly before
/// the eye.
CarLayer::Rectangle CarLayer::extent(const bowl::Perspective& perspective) const {
  const Rectangle whole(Eigen::Vector2i(0, 0), size_px_ - Eigen::Vector2i::Ones());
  Eigen::AlignedBox3d box = box_;
  box.extend(Eigen::Vector3d(shadow_reach_.x(), shadow_reach_.y(), 0));
  box.extend(Eigen::Vector3d(-shadow_reach_.x(), -shadow_reach_.y(), 0));
  Eigen::AlignedBox2d around;
  int before = 0;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    if (perspective.vehicle_from_picture().col(2).dot(corner - perspective.eye()) < near_m_) continue;
    ++before;
    around.extend(*perspective.project(corner));
  }
  if (before == 0) return {};
  if (before < 8) return whole;
  const Eigen::Vector2d most = size_px_.cast<double>(), least = Eigen::Vector2d::Constant(-2);
  const Rectangle all(around.min().cwiseMax(least).cwiseMin(most).array().floor().matrix().cast<int>(),
                      around.max().cwiseMax(least).cwiseMin(most).array().ceil().matrix().cast<int>());
  return whole.intersection(all);
}

void CarLayer::make_room(const Eigen::Vector2i& size_px) {
  if ((size_px.array() <= room_px_.array()).all()) return;
  const Eigen::Vector2i size = room_px_ = room_px_.cwiseMax(size_px);
  surfaces_.emplace(make_texture(kSurfacesUnit, kLinear, size.x(), size.y(), GL_NEAREST));
  const auto attach = [&](GLenum attachment, const Renderbuffer& buffer, GLenum format) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, sample_count_, format, size.x(), size.y());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
  };
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.name());
  attach(GL_COLOR_ATTACHMENT0, sample_colours_, kLinear);
  attach(GL_DEPTH_ATTACHMENT, sample_depths_, GL_DEPTH_COMPONENT24);
  require_complete_framebuffer("the car's samples");
  glBindFramebuffer(GL_FRAMEBUFFER, pixels_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, surfaces_->name(), 0);
  require_complete_framebuffer("the car's pixels");
}

/// In textures just large enough: they begin at the rectangle's corner.
void CarLayer::draw_surfaces(const bowl::Perspective& perspective) {
  const Eigen::Vector2i size = rectangle_.sizes() + Eigen::Vector2i::Ones();
  make_room(size);
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.name());
  glViewport(-rectangle_.min().x(), -rectangle_.min().y(), size_px_.x(), size_px_.y());
  glDisable(GL_CULL_FACE);
  glFrontFace(GL_CW);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  surface_.use();
  const Eigen::Matrix4f clip = clip_from_vehicle(perspective, size_px_, near_m_).cast<float>();
  glUniformMatrix4fv(surface_at_.clip_from_vehicle, 1, GL_FALSE, clip.data());
  set(surface_at_.eye, perspective.eye().cast<float>());
  glBindVertexArray(vertex_array_.name());
  draw_parts(true);
  // Of the translucent surfaces only the nearest: first their depths, then what lies there.
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_parts(false);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_EQUAL);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_parts(false);

  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, pixels_.name());
  glBlitFramebuffer(0, 0, room_px_.x(), room_px_.y(), 0, 0, room_px_.x(), room_px_.y(), GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
}

void CarLayer::draw_parts(bool opaque) const {
  for (const car::Part& part : parts_) {
    const car::Material& material = part.material;
    if (material.opaque() != opaque) continue;
    set(surface_at_.base_colour, material.base_colour);
    glUniform1f(surface_at_.opacity, material.opacity);
    glUniform1f(surface_at_.gloss, material.gloss);
    glUniform1f(surface_at_.metallic, material.metallic);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.index_count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(part.first_index * sizeof(uint32_t)));
  }
}

void CarLayer::lay_over(float opacity) const {
  if (rectangle_.isEmpty()) return;
  const bowl::Perspective perspective(viewpoint_, size_px_);
  glViewport(0, 0, size_px_.x(), size_px_.y());
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const Eigen::Vector2i size = rectangle_.sizes() + Eigen::Vector2i::Ones();
  glEnable(GL_SCISSOR_TEST);
  glScissor(rectangle_.min().x(), rectangle_.min().y(), size.x(), size.y());

  lay_.use();
  const Eigen::Vector3d first = perspective.ray({-0.5, -0.5});  // gl_FragCoord counts from pixels' corners
  glUniform2f(lay_at_.rectangle, static_cast<float>(rectangle_.min().x()),
              static_cast<float>(rectangle_.min().y()));
  set(lay_at_.eye, perspective.eye().cast<float>());
  set(lay_at_.ray, first.cast<float>());
  set(lay_at_.ray_right, (perspective.ray({0.5, -0.5}) - first).cast<float>());
  set(lay_at_.ray_down, (perspective.ray({-0.5, 0.5}) - first).cast<float>());
  glUniform1f(lay_at_.car_opacity, opacity);
  bind(kSurfacesUnit, *surfaces_);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace svchain::gl
