#pragma once
// The side-by-side comparisons, each interleaved with what it is compared with. They take minutes; one at a
// time on a machine that does nothing else.

#include <functional>
#include <string>

#include "usecases/svchain_bench/results.h"

namespace svchain::bench {

/// Called with the name of what is measured next.
using Progress = std::function<void(const std::string&)>;

void compare_hops(Results& results, const Progress& progress);
/// Synthesis beside OpenCV, and the whole use case beside the kernels that it is made of.
void compare_synthesis(Results& results, const Progress& progress);
void compare_use_case(Results& results, const Progress& progress);
/// The 3D view, by graphics and without.
void compare_bowl(Results& results, const Progress& progress);

}  // namespace svchain::bench
