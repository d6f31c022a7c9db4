#pragma once
// Names that OpenGL hands out, each given back when its owner goes; the context is in use then, as when they
// were made. Move-only. Internal to algorithms/gl.

#include <epoxy/gl.h>
#include <string>
#include <utility>

namespace svchain::gl {

/// kMake and kGiveBack are what epoxy calls OpenGL's functions through.
template <auto& kMake, auto& kGiveBack>
class Named {
 public:
  Named() { kMake(1, &name_); }
  Named(Named&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Named& operator=(Named&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Named() {
    if (name_) kGiveBack(1, &name_);
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

using Buffer = Named<glGenBuffers, glDeleteBuffers>;
using Texture = Named<glGenTextures, glDeleteTextures>;
using Renderbuffer = Named<glGenRenderbuffers, glDeleteRenderbuffers>;
using Framebuffer = Named<glGenFramebuffers, glDeleteFramebuffers>;
using VertexArray = Named<glGenVertexArrays, glDeleteVertexArrays>;

class Program {
 public:
  /// Throws std::runtime_error with the compiler's or linker's log.
  Program(const std::string& vertex_shader, const std::string& fragment_shader);
  Program(Program&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Program& operator=(Program&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Program() {
    if (name_) glDeleteProgram(name_);
  }

  void use() const { glUseProgram(name_); }
  /// -1, which sets nothing, for what the program does not use.
  GLint uniform(const char* name) const { return glGetUniformLocation(name_, name); }

 private:
  explicit Program(GLuint name) : name_(name) {}

  GLuint name_ = 0;
};

/// A texture without mipmaps, bound to a unit: clamped to its edge, with `filter` (GL_LINEAR, GL_NEAREST).
Texture make_texture(int unit, GLenum format, int width, int height, GLint filter);
void bind(int unit, const Texture& texture);

/// Throws std::runtime_error where drawing into what is bound to GL_FRAMEBUFFER is not possible.
void require_complete_framebuffer(const char* what);

}  // namespace svchain::gl
