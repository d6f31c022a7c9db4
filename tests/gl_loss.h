#pragma once
// A driver that gives contexts up, which Mesa on the CPU never does: OpenGL's and EGL's functions are called
// through epoxy's pointers, and these point elsewhere as long as a GlLoss lives. One at a time, no other
// thread in GL meanwhile.

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <utility>

namespace svchain::testing {

class GlLoss {
 public:
  enum class Kind {
    kOnce,     // the first that is asked for is lost
    kAlways,   // every context is, and so is a new one
    kForGood,  // the same, and there is no new one: as where the GPU is gone
  };

  explicit GlLoss(Kind kind) {
    epoxy_glGetGraphicsResetStatus = kind == Kind::kOnce ? lost_once : lost;
    questions_ = 0;
    if (kind != Kind::kForGood) return;
    epoxy_eglCreateContext = no_context;
    epoxy_eglGetError = bad_allocation;
  }
  ~GlLoss() {
    epoxy_glGetGraphicsResetStatus = status_;
    epoxy_eglCreateContext = create_;
    epoxy_eglGetError = error_;
  }
  GlLoss(const GlLoss&) = delete;
  GlLoss& operator=(const GlLoss&) = delete;

  /// How often the driver was asked whether the context is lost.
  static int questions() { return questions_; }

 private:
  static GLenum lost() {
    ++questions_;
    return GL_INNOCENT_CONTEXT_RESET;
  }
  static GLenum lost_once() { return questions_++ == 0 ? GL_INNOCENT_CONTEXT_RESET : GL_NO_ERROR; }
  static EGLContext no_context(EGLDisplay, EGLConfig, EGLContext, const EGLint*) { return EGL_NO_CONTEXT; }
  static EGLint bad_allocation() { return EGL_BAD_ALLOC; }

  static inline int questions_ = 0;
  decltype(epoxy_glGetGraphicsResetStatus) status_ = epoxy_glGetGraphicsResetStatus;
  decltype(epoxy_eglCreateContext) create_ = epoxy_eglCreateContext;
  decltype(epoxy_eglGetError) error_ = epoxy_eglGetError;
};

}  // namespace svchain::testing
