#pragma once
// Draws the bowl: one call for each batch of the mesh table, with a shader of its own for batches of one
// camera. Internal to algorithms/gl; the context is in use.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/bowl/mesh_table.h"
#include "algorithms/bowl/viewpoint.h"
#include "algorithms/gl/camera_textures.h"
#include "algorithms/gl/gl_objects.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::gl {

class BowlPass {
 public:
  BowlPass();
  /// `lens_centre_px` by camera.
  void set_mesh(const bowl::MeshTable& mesh, const std::array<Eigen::Vector2f, kCameraCount>& lens_centre_px);
  /// Into the framebuffer bound, over black.
  void draw(const CameraTextures& cameras, const synthesis::ToneMapping& tone_mapping,
            const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px);

 private:
  struct CameraUniforms {
    GLint number, size_px, group, bgr_of_yuv, falloff, lens;
  };
  struct Shading {
    explicit Shading(unsigned variant);
    Program program;
    GLint clip_from_unit;
    std::array<CameraUniforms, 2> camera;
  };
  const Shading& shading(unsigned variant);
  void upload_curves(const synthesis::ToneMapping& tone_mapping);
  void set_camera(const CameraUniforms& uniforms, const CameraTextures& cameras,
                  const synthesis::ToneMapping& tone_mapping, size_t camera) const;
  void black_out_back_sides(const Eigen::Matrix4f& clip_from_unit);

  VertexArray vertex_array_;
  Buffer vertices_, indices_;
  Texture curves_;
  std::vector<std::optional<Shading>> shadings_;  // by variant
  Program black_;
  std::vector<bowl::MeshBatch> batches_;
  GLsizei index_count_ = 0;
  double metres_per_unit_ = 1;
  bowl::BowlSurface surface_;
  std::array<Eigen::Vector2f, kCameraCount> image_size_px_, lens_centre_px_;
};

}  // namespace svchain::gl
