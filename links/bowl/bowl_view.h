#pragma once
// Link "bowl_view": the 3D view on a core without graphics: a LUT of the viewpoint
// (algorithms/bowl/viewpoint_lut.h), made anew where the viewpoint, the rig or the bowl has changed, read
// through by the kernels of synthesis, and the car laid over it. Errors: the faults of its parameters;
// std::runtime_error for a rig that cannot be read.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_bowl_view();

}  // namespace svchain
