#pragma once
// The plots of docs/performance.md, SVG. Pure functions.

#include <string>

#include "usecases/svchain_bench/growth.h"
#include "usecases/svchain_bench/results.h"

namespace svchain::bench {

/// All ratios that were measured.
std::string ratio_plot(const Results& results);
std::string size_plot(const Growth& growth);
std::string links_plot(const Growth& growth);

}  // namespace svchain::bench
