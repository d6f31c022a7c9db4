#include "algorithms/gl/gl_context.h"

#include <array>
#include <cstdio>
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace svchain::gl {
namespace {

std::string hexadecimal(unsigned value) {
  std::array<char, 16> text;
  std::snprintf(text.data(), text.size(), "0x%04X", value);
  return text.data();
}

std::string egl_error_name(EGLint error) {
  switch (error) {
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_CONTEXT:
      return "EGL_BAD_CONTEXT";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    case EGL_CONTEXT_LOST:
      return "EGL_CONTEXT_LOST";
    default:
      return "EGL error " + hexadecimal(static_cast<unsigned>(error));
  }
}

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("no OpenGL ES 3: " + what);
}

[[noreturn]] void fail_egl(const std::string& call) {
  fail(call + " failed with " + egl_error_name(eglGetError()));
}

/// epoxy ends the program where these are not there.
void require_libraries() {
  for (const char* name : {"libEGL.so.1", "libGLESv2.so.2"}) {
    void* const library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    if (!library) fail(dlerror());
    dlclose(library);
  }
}

}  // namespace

class GlContext::Display {
 public:
  Display() {
    require_libraries();
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
      fail("EGL has no EGL_MESA_platform_surfaceless (Debian: libegl-mesa0)");
    handle = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!handle) fail_egl("eglGetPlatformDisplayEXT");
    if (!eglInitialize(handle, nullptr, nullptr)) fail_egl("eglInitialize");
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// EGL gives everybody the same one. It stays until the process ends: ending it would end it for others in
  /// the process too, and Mesa forgets memory when it unloads its driver.
  static const Display& shared() {
    static const Display* const display = new Display;
    return *display;
  }
  void require(const char* extension) const {
    if (!epoxy_has_egl_extension(handle, extension)) fail(std::string("EGL has no ") + extension);
  }

  EGLDisplay handle;
};

GlContext::GlContext() : display_(&Display::shared()) {
  display_->require("EGL_KHR_surfaceless_context");
  display_->require("EGL_KHR_no_config_context");
  if (!eglBindAPI(EGL_OPENGL_ES_API)) fail_egl("eglBindAPI");
  const bool robust = epoxy_has_egl_extension(display_->handle, "EGL_EXT_create_context_robustness");
  const std::array<EGLint, 5> attributes = {
      EGL_CONTEXT_MAJOR_VERSION, 3, robust ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT : EGL_NONE,
      EGL_LOSE_CONTEXT_ON_RESET_EXT, EGL_NONE};
  context_ = eglCreateContext(display_->handle, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (!context_) fail_egl("eglCreateContext");
  try {
    const Use use(*this);
    renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    version_ = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    tells_resets_ = robust && (epoxy_gl_version() >= 32 || epoxy_has_gl_extension("GL_KHR_robustness") ||
                               epoxy_has_gl_extension("GL_EXT_robustness"));
  } catch (...) {
    eglDestroyContext(display_->handle, context_);
    throw;
  }
}

GlContext::~GlContext() {
  eglDestroyContext(display_->handle, context_);
}

GlContext::Use::Use(const GlContext& context) {
  const EGLContext current = eglGetCurrentContext();
  if (current == context.context_) return;
  if (current != EGL_NO_CONTEXT)
    throw std::runtime_error("OpenGL ES: this thread already uses another context");
  const EGLDisplay display = context.display_->handle;
  eglBindAPI(EGL_OPENGL_ES_API);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_)) {
    const EGLint error = eglGetError();
    if (error == EGL_CONTEXT_LOST) throw GlLost("OpenGL ES: the context is lost (EGL_CONTEXT_LOST)");
    throw std::runtime_error("OpenGL ES: the context cannot be used by this thread (" +
                             egl_error_name(error) + "); does another thread use it?");
  }
  display_ = display;
}

GlContext::Use::~Use() {
  if (display_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void GlContext::require_not_lost() const {
  if (tells_resets_) require_no_reset(glGetGraphicsResetStatus());
}

void require_no_reset(unsigned status) {
  if (status == GL_NO_ERROR) return;
  const std::string why = status == GL_GUILTY_CONTEXT_RESET     ? "reset by what it drew"
                          : status == GL_INNOCENT_CONTEXT_RESET ? "reset because of another context"
                                                                : "reset, and the driver does not know why";
  throw GlLost("OpenGL ES: the context is lost: " + why + " (" + hexadecimal(status) + ")");
}

}  // namespace svchain::gl
