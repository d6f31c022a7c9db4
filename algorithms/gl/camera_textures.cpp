#include "algorithms/gl/camera_textures.h"

#include <cstring>

#include "algorithms/gl/packed_bgr.h"

namespace svchain::gl {
namespace {

using colour::Picture;
using colour::PixelFormat;

constexpr int kUnit = 0;  // that uploads go through

/// Rows of any pitch into the texture bound.
void upload_rows(GLenum format, size_t bytes_per_texel, int width, int height, const uint8_t* rows,
                 size_t pitch_bytes) {
  if (pitch_bytes % bytes_per_texel == 0) {
    glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(pitch_bytes / bytes_per_texel));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, format, GL_UNSIGNED_BYTE, rows);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    return;
  }
  for (int y = 0; y < height; ++y, rows += pitch_bytes)
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, y, width, 1, format, GL_UNSIGNED_BYTE, rows);
}

}  // namespace

CameraTextures::CameraTextures() : black_(make_texture(kUnit, GL_RGBA8, 1, 1, GL_NEAREST)) {
  const uint32_t black = 0;
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &black);
}

CameraTextures::Textures CameraTextures::make(const Picture& frame) const {
  const int w = frame.width_px, h = frame.height_px;
  if (frame.format == PixelFormat::kBgr8)
    return {frame.format, w, h, make_texture(kUnit, GL_RGBA8, w, h, GL_LINEAR), {}};
  if (frame.format == PixelFormat::kNv12)
    return {frame.format, w, h, make_texture(kUnit, GL_R8, w, h, GL_LINEAR),
            make_texture(kUnit, GL_RG8, w / 2, h / 2, GL_LINEAR)};
  // The same bytes as pixels of Y and something, and as groups Y U Y V.
  Textures textures{frame.format, w, h, make_texture(kUnit, GL_RG8, w, h, GL_LINEAR),
                    make_texture(kUnit, GL_RGBA8, w / 2, h, GL_LINEAR)};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_GREEN);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_ALPHA);
  return textures;
}

void CameraTextures::upload(std::span<const Picture> frames) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (size_t c = 0; c < kCameraCount; ++c) {
    const Picture& frame = frames[c];
    frames_[c] = {};
    empty_[c] = frame.empty();
    if (empty_[c]) continue;
    auto& textures = textures_[c];
    if (!textures || textures->format != frame.format || textures->width != frame.width_px ||
        textures->height != frame.height_px)
      textures.emplace(make(frame));
    upload(*textures, frame);
    if (frame.format != PixelFormat::kBgr8)
      frames_[c] = {true, {2, frame.format == PixelFormat::kNv12 ? 2 : 1}, frame.encoding};
  }
}

void CameraTextures::upload(const Textures& textures, const Picture& frame) {
  const int w = frame.width_px, h = frame.height_px;
  bind(kUnit, textures.picture);
  if (frame.format == PixelFormat::kBgr8) return upload_bgr(frame);
  const bool nv12 = frame.format == PixelFormat::kNv12;
  upload_rows(nv12 ? GL_RED : GL_RG, nv12 ? 1 : 2, w, h, frame.pixels, frame.pitch_bytes);
  bind(kUnit, *textures.chroma);
  if (nv12)
    upload_rows(GL_RG, 2, w / 2, h / 2, frame.chroma, frame.pitch_bytes);
  else
    upload_rows(GL_RGBA, 4, w / 2, h, frame.pixels, frame.pitch_bytes);
}

/// Drivers take four channels several times as fast as three.
void CameraTextures::upload_bgr(const Picture& frame) {
  const auto w = static_cast<size_t>(frame.width_px), h = static_cast<size_t>(frame.height_px);
  four_channels_.resize(w * h);
  for (size_t y = 0; y < h; ++y) unpack_bgr(frame.pixels + y * frame.pitch_bytes, w, &four_channels_[y * w]);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, frame.width_px, frame.height_px, GL_RGBA, GL_UNSIGNED_BYTE,
                  four_channels_.data());
}

void CameraTextures::bind_frame(size_t camera, int picture_unit, int chroma_unit) const {
  const auto& textures = textures_[camera];
  bind(picture_unit, empty_[camera] ? black_ : textures->picture);
  bind(chroma_unit, !empty_[camera] && textures->chroma ? *textures->chroma : black_);
}

}  // namespace svchain::gl
