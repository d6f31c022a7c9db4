#pragma once
// Link "bowl_view_gl": the 3D view drawn by OpenGL ES 3 (algorithms/gl/bowl_renderer.h) from a mesh table,
// without a window, on a GPU or on the CPU by Mesa. Where there is no OpenGL ES, or none any more, the CPU
// draws instead as "bowl_view" does (parameter "without_gl"), the report warns of it and says why, and the
// chain goes on.
// Errors: the faults of its parameters; std::runtime_error for a mesh table or rig that cannot be read.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_bowl_view_gl();

}  // namespace svchain
