#pragma once
// Link "mesh_table": the bowl as triangles for the graphics (algorithms/bowl/mesh_table.h), made from the
// calibrated rig on a core of its own, so that whoever draws goes on with the old one meanwhile; again when
// the rig or the bowl has changed. The frames only set the pace, nothing looks at them. Errors: the faults of
// its settings; std::runtime_error for a rig that cannot be read.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_mesh_table();

}  // namespace svchain
