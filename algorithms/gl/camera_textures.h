#pragma once
// The four cameras' frames as textures. In all of them and in what is drawn from them, red holds blue and
// blue red: bytes stay in the order b, g, r. Internal to algorithms/gl; the context is in use.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/colour/picture.h"
#include "algorithms/gl/gl_objects.h"

namespace svchain::gl {

inline constexpr size_t kCameraCount = 4;

class CameraTextures {
 public:
  /// What a shader has to know of a camera's frame, besides its texture.
  struct Frame {
    bool yuv = false;
    std::array<int, 2> group = {1, 1};  // pixels that share their chroma, across and down
    colour::YuvEncoding encoding = colour::YuvEncoding::kBt601Limited;
  };

  CameraTextures();
  /// An empty frame is black. Allocates where a frame's format or size is another than before.
  void upload(std::span<const colour::Picture> frames);

  const Frame& frame(size_t camera) const { return frames_[camera]; }
  /// The picture (for YUV its luma) and the chroma, U in red, V in green.
  void bind_frame(size_t camera, int picture_unit, int chroma_unit) const;

 private:
  struct Textures {
    colour::PixelFormat format;
    int width, height;
    Texture picture;
    std::optional<Texture> chroma;
  };
  Textures make(const colour::Picture& frame) const;
  void upload(const Textures& textures, const colour::Picture& frame);
  void upload_bgr(const colour::Picture& frame);

  Texture black_;
  std::array<std::optional<Textures>, kCameraCount> textures_;
  std::array<Frame, kCameraCount> frames_;
  std::array<bool, kCameraCount> empty_ = {true, true, true, true};  // before the first upload
  std::vector<uint32_t> four_channels_;                              // of a BGR frame
};

}  // namespace svchain::gl
