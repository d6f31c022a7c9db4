#pragma once
// Whether there is OpenGL ES here at all; says so where there is not.

#include <stdexcept>

#include "algorithms/gl/gl_context.h"
#include "tests/catch.h"

namespace svchain::testing {

inline bool has_gl() {
  try {
    const gl::GlContext context;
    return true;
  } catch (const std::runtime_error& error) {
    WARN("skipped: " << error.what());
    return false;
  }
}

}  // namespace svchain::testing
