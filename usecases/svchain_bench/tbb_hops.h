#pragma once
// What library_hops.h says of TBB; there only where TBB is.

#include <string>

namespace svchain::bench {

std::string tbb_version();
double tbb_stream_ns(int messages);
double tbb_line_ns(int nodes, int messages);

}  // namespace svchain::bench
