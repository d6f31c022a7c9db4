#pragma once
// docs/performance.md and the plots beside it. Pure function.

#include <string>
#include <utility>
#include <vector>

#include "usecases/svchain_bench/growth.h"
#include "usecases/svchain_bench/results.h"
#include "usecases/svchain_bench/versions.h"

namespace svchain::bench {

struct Measured {
  Results results;
  Growth growth;
  Machine machine;
  Versions versions;
  std::string date;
};

/// Names and contents. The page is `stem`.md, the plots `stem`_ratios.svg, `stem`_size.svg and
/// `stem`_links.svg, which the page shows from the same folder.
using Files = std::vector<std::pair<std::string, std::string>>;
Files performance_page(const Measured& measured, const std::string& stem);

}  // namespace svchain::bench
