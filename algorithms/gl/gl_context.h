#pragma once
// OpenGL ES 3 without a window: EGL on Mesa's surfaceless platform, on a GPU or on the CPU (llvmpipe). Any
// number of contexts in a process; a thread uses one by a GlContext::Use, and a context is used by one thread
// at a time.

#include <stdexcept>
#include <string>

namespace svchain::gl {

/// The driver has given the context up (a reset GPU, or one that is gone): everything in it is lost, and a
/// new context has to be made.
class GlLost : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class GlContext {
 public:
  /// Throws std::runtime_error that says what is missing, with EGL's error.
  GlContext();
  /// No Use of it may be left.
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes the context the calling thread's as long as it lives, where it is not already. Throws
  /// std::runtime_error where another thread uses it or this thread another one, GlLost where it is lost.
  class Use {
   public:
    explicit Use(const GlContext& context);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    void* display_ = nullptr;  // null: was in use before
  };

  /// What draws, such as "llvmpipe (LLVM 15.0.6, 256 bits)", and what it speaks, "OpenGL ES 3.2 Mesa 22.3.6".
  const std::string& renderer() const { return renderer_; }
  const std::string& version() const { return version_; }
  /// Whether it is Mesa on the CPU that draws.
  bool on_cpu() const { return renderer_.starts_with("llvmpipe") || renderer_.starts_with("softpipe"); }

  /// Throws GlLost where the driver says that the context is; does nothing where it cannot tell. In use.
  void require_not_lost() const;

 private:
  class Display;

  const Display* display_;  // one for all contexts
  void* context_ = nullptr;
  bool tells_resets_ = false;
  std::string renderer_, version_;
};

/// Throws GlLost, naming the status, for everything that glGetGraphicsResetStatus answers but GL_NO_ERROR.
void require_no_reset(unsigned status);

}  // namespace svchain::gl
