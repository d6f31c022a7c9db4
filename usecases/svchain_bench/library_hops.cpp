#include "usecases/svchain_bench/library_hops.h"

#ifdef SVCHAIN_WITH_TBB
#include "usecases/svchain_bench/tbb_hops.h"
#endif
#ifdef SVCHAIN_WITH_GSTREAMER
#include "usecases/svchain_bench/gstreamer_hops.h"
#endif

namespace svchain::bench {

std::optional<Library> tbb_flow_graph() {
#ifdef SVCHAIN_WITH_TBB
  return Library{tbb_version(), tbb_stream_ns, tbb_line_ns};
#else
  return std::nullopt;
#endif
}

std::optional<Library> gstreamer_queue() {
#ifdef SVCHAIN_WITH_GSTREAMER
  return Library{gstreamer_version(), gstreamer_stream_ns, nullptr};
#else
  return std::nullopt;
#endif
}

}  // namespace svchain::bench
