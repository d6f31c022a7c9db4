#include "algorithms/gl/bowl_pass.h"

#include <string>

#include "algorithms/gl/bowl_shaders.h"
#include "algorithms/gl/projection.h"
#include "algorithms/synthesis/fixed_point.h"

namespace svchain::gl {
namespace {

// Variants of the shader, added up.
constexpr unsigned kBlended = 1, kFirstYuv = 2, kSecondYuv = 4, kFalloff = 8, kVariants = 16;
constexpr int kCurvesUnit = 4;  // the cameras' are 0 to 3
constexpr double kNearM = 1e-3;

constexpr const char* kBlackFragmentShader = R"(#version 300 es
precision mediump float;
out vec4 shown;
void main() { shown = vec4(0.0, 0.0, 0.0, 1.0); }
)";

std::string with_variant(unsigned variant, const char* shader) {
  std::string text = "#version 300 es\n";
  if (variant & kBlended) text += "#define BLENDED\n";
  if (variant & kFirstYuv) text += "#define FIRST_YUV\n";
  if (variant & kSecondYuv) text += "#define SECOND_YUV\n";
  if (variant & kFalloff) text += "#define FALLOFF\n";
  return text + shader;
}

/// bgr_of (colour/yuv.h) of 0..1, by columns: y, u, v, 1.
std::array<float, 12> bgr_of_yuv(colour::YuvEncoding encoding) {
  const colour::YuvMatrix& m = colour::yuv_matrix(encoding);
  const auto factor = [](int16_t fixed) { return static_cast<float>(fixed) / 8192; };
  const float y = factor(m.of_y), bu = factor(m.b_of_u), gu = factor(m.g_of_u), gv = factor(m.g_of_v),
              rv = factor(m.r_of_v);
  const float black = static_cast<float>(m.offset) / 255, grey = 128.0f / 255;
  return {y,
          y,
          y,  //
          bu,
          gu,
          0,  //
          0,
          gv,
          rv,  //
          -y * black - bu * grey,
          -y * black - (gu + gv) * grey,
          -y * black - rv * grey};
}

const void* offset(size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

}  // namespace

BowlPass::Shading::Shading(unsigned variant)
    : program(with_variant(variant, kBowlVertexShader), with_variant(variant, kBowlFragmentShader)),
      clip_from_unit(program.uniform("clip_from_unit")) {
  for (size_t i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? "first." : "second.";
    const auto uniform = [&](const char* member) { return program.uniform((name + member).c_str()); };
    camera[i] = {uniform("number"),     uniform("size_px"), uniform("group"),
                 uniform("bgr_of_yuv"), uniform("falloff"), uniform("lens")};
  }
  program.use();
  int unit = 0;
  for (const char* sampler : {"first_picture", "first_chroma", "second_picture", "second_chroma"})
    glUniform1i(program.uniform(sampler), unit++);
  glUniform1i(program.uniform("curves"), kCurvesUnit);
}

BowlPass::BowlPass()
    : curves_(make_texture(kCurvesUnit, GL_RGBA8, 256, kCameraCount, GL_NEAREST)),
      shadings_(kVariants),
      black_(with_variant(0, kBowlVertexShader), kBlackFragmentShader) {
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  using Vertex = bowl::MeshVertex;
  constexpr GLsizei kStride = sizeof(Vertex);
  glVertexAttribPointer(0, 3, GL_SHORT, GL_FALSE, kStride, offset(offsetof(Vertex, position)));
  glVertexAttribPointer(1, 1, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset(offsetof(Vertex, first_weight)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_SHORT, GL_TRUE, kStride, offset(offsetof(Vertex, texture)));
  for (const GLuint attribute : {0u, 1u, 2u}) glEnableVertexAttribArray(attribute);
}

void BowlPass::set_mesh(const bowl::MeshTable& mesh,
                        const std::array<Eigen::Vector2f, kCameraCount>& lens_centre_px) {
  const bowl::MeshHeader& header = mesh.header();
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices().size_bytes()), mesh.vertices().data(),
               GL_STATIC_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices().size_bytes()),
               mesh.indices().data(), GL_STATIC_DRAW);
  batches_.assign(mesh.batches().begin(), mesh.batches().end());
  index_count_ = static_cast<GLsizei>(header.index_count);
  metres_per_unit_ = header.metres_per_unit;
  surface_ = {static_cast<bowl::FloorShape>(header.floor_shape),
              header.floor_length_m,
              header.floor_width_m,
              header.rise_m,
              header.height_m,
              header.exponent};
  for (size_t c = 0; c < kCameraCount; ++c)
    image_size_px_[c] = Eigen::Vector2i(header.image_size_px[c][0], header.image_size_px[c][1]).cast<float>();
  lens_centre_px_ = lens_centre_px;
}

const BowlPass::Shading& BowlPass::shading(unsigned variant) {
  auto& made = shadings_[variant];
  if (!made) made.emplace(variant);
  return *made;
}

void BowlPass::upload_curves(const synthesis::ToneMapping& tone_mapping) {
  std::array<std::array<std::array<uint8_t, 4>, 256>, kCameraCount> texels{};
  for (size_t c = 0; c < kCameraCount; ++c)
    for (size_t channel = 0; channel < synthesis::kChannels; ++channel)
      for (size_t i = 0; i < 256; ++i) texels[c][i][channel] = tone_mapping.curves[c][channel][i];
  bind(kCurvesUnit, curves_);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 256, kCameraCount, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

void BowlPass::set_camera(const CameraUniforms& uniforms, const CameraTextures& cameras,
                          const synthesis::ToneMapping& tone_mapping, size_t camera) const {
  const CameraTextures::Frame& frame = cameras.frame(camera);
  const Eigen::Vector2f &size = image_size_px_[camera], &centre = lens_centre_px_[camera];
  const auto& falloff = tone_mapping.falloff[camera];
  const auto a = [&](int i) { return static_cast<float>(falloff[i]) / synthesis::kRadialOne; };
  glUniform1i(uniforms.number, static_cast<GLint>(camera));
  glUniform2f(uniforms.size_px, size.x(), size.y());
  glUniform2f(uniforms.group, static_cast<float>(frame.group[0]), static_cast<float>(frame.group[1]));
  glUniformMatrix4x3fv(uniforms.bgr_of_yuv, 1, GL_FALSE, bgr_of_yuv(frame.encoding).data());
  glUniform2f(uniforms.falloff, a(0), a(1));
  glUniform3f(uniforms.lens, centre.x() + 0.5f, centre.y() + 0.5f, 2 / size.x());
}

void BowlPass::draw(const CameraTextures& cameras, const synthesis::ToneMapping& tone_mapping,
                    const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px) {
  upload_curves(tone_mapping);
  const bowl::Perspective perspective(viewpoint, size_px);
  Eigen::Matrix4d clip = clip_from_vehicle(perspective, size_px, kNearM);
  clip.leftCols<3>() *= metres_per_unit_;
  const Eigen::Matrix4f clip_from_unit = clip.cast<float>();

  glViewport(0, 0, size_px.x(), size_px.y());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  // From above a bowl nothing hides anything: it is convex. Its outside is not to be seen.
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CW);
  glCullFace(GL_BACK);
  glBindVertexArray(vertex_array_.name());
  for (const bowl::MeshBatch& batch : batches_) {
    const std::array<size_t, 2> pair = {batch.first, batch.second};
    const bool blended = batch.first != batch.second;
    unsigned variant = blended ? kBlended : 0;
    if (cameras.frame(pair[0]).yuv) variant |= kFirstYuv;
    if (blended && cameras.frame(pair[1]).yuv) variant |= kSecondYuv;
    if (tone_mapping.has_falloff(pair[0]) || tone_mapping.has_falloff(pair[1])) variant |= kFalloff;
    const Shading& shading = this->shading(variant);
    shading.program.use();
    glUniformMatrix4fv(shading.clip_from_unit, 1, GL_FALSE, clip_from_unit.data());
    for (int i = 0; i < (blended ? 2 : 1); ++i) {
      set_camera(shading.camera[i], cameras, tone_mapping, pair[i]);
      cameras.bind_frame(pair[i], 2 * i, 2 * i + 1);
    }
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.index_count), GL_UNSIGNED_SHORT,
                   offset(batch.first_index * sizeof(uint16_t)));
  }
  const Eigen::Vector3d& eye = perspective.eye();
  if (eye.z() < surface_.height_at(eye.head<2>())) black_out_back_sides(clip_from_unit);
}

/// An eye beyond the rim sees the wall from outside before it sees what is inside.
void BowlPass::black_out_back_sides(const Eigen::Matrix4f& clip_from_unit) {
  black_.use();
  glUniformMatrix4fv(black_.uniform("clip_from_unit"), 1, GL_FALSE, clip_from_unit.data());
  glCullFace(GL_FRONT);
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, offset(0));
}

}  // namespace svchain::gl
