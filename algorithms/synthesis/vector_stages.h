#pragma once
// The kernels with vector instructions, made of one source (Highway). Internal to synthesis.

#include "algorithms/synthesis/kernel.h"
#include "algorithms/synthesis/stages.h"

namespace svchain::synthesis {

/// Null for a kernel that this processor does not run, and for the portable one.
const Stages* vector_stages(Kernel kernel);

}  // namespace svchain::synthesis
