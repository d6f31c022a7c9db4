#include "algorithms/gl/gl_objects.h"

#include <cstdio>
#include <stdexcept>
#include <vector>

namespace svchain::gl {
namespace {

class Shader {
 public:
  Shader(GLenum kind, const std::string& source) : name(glCreateShader(kind)) {
    const char* const text = source.c_str();
    glShaderSource(name, 1, &text, nullptr);
    glCompileShader(name);
  }
  ~Shader() { glDeleteShader(name); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  void require_compiled(const char* what) const {
    GLint compiled = 0, length = 0;
    glGetShaderiv(name, GL_COMPILE_STATUS, &compiled);
    if (compiled) return;
    glGetShaderiv(name, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> log(static_cast<size_t>(length) + 1);
    glGetShaderInfoLog(name, length, nullptr, log.data());
    throw std::runtime_error(std::string("OpenGL ES: the ") + what +
                             " shader does not compile: " + log.data());
  }

  const GLuint name;
};

}  // namespace

Program::Program(const std::string& vertex_shader, const std::string& fragment_shader) {
  const Shader vertex(GL_VERTEX_SHADER, vertex_shader), fragment(GL_FRAGMENT_SHADER, fragment_shader);
  vertex.require_compiled("vertex");
  fragment.require_compiled("fragment");
  Program made{glCreateProgram()};
  glAttachShader(made.name_, vertex.name);
  glAttachShader(made.name_, fragment.name);
  glLinkProgram(made.name_);
  GLint linked = 0, length = 0;
  glGetProgramiv(made.name_, GL_LINK_STATUS, &linked);
  if (!linked) {
    glGetProgramiv(made.name_, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> log(static_cast<size_t>(length) + 1);
    glGetProgramInfoLog(made.name_, length, nullptr, log.data());
    throw std::runtime_error(std::string("OpenGL ES: the shaders do not link: ") + log.data());
  }
  glDetachShader(made.name_, vertex.name);
  glDetachShader(made.name_, fragment.name);
  std::swap(name_, made.name_);
}

Texture make_texture(int unit, GLenum format, int width, int height, GLint filter) {
  Texture texture;
  bind(unit, texture);
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void bind(int unit, const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture.name());
}

void require_complete_framebuffer(const char* what) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  char text[16];
  std::snprintf(text, sizeof(text), "0x%04X", status);
  throw std::runtime_error(std::string("OpenGL ES cannot draw into ") + what + " (" + text + ")");
}

}  // namespace svchain::gl
