#pragma once
// The libraries that measurements depend on, in the order of a page. Any thread.

#include <string>
#include <utility>
#include <vector>

namespace svchain::bench {

/// Names and versions; "not installed" for what was not there when this was built.
using Versions = std::vector<std::pair<std::string, std::string>>;
Versions these_versions();

}  // namespace svchain::bench
