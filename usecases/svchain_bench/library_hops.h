#pragma once
// Streams and lines of nodes by libraries that need not be installed. Measured like those in other_hops.h;
// threads are there before the clock starts. Throws std::runtime_error where a message is lost or out of
// order.

#include <functional>
#include <optional>
#include <string>

namespace svchain::bench {

struct Library {
  std::string version;
  /// Put in by one thread and taken out by another as soon as it can, ns per message of this many.
  std::function<double(int messages)> stream_ns;
  /// Through this many nodes on one thread, ns per message; empty where there is no such thing.
  std::function<double(int nodes, int messages)> line_ns;
};

/// None where it was not installed when this was built.
/// TBB: nodes of a flow graph that take one message at a time. No bound on what waits, which costs the least;
/// which of two threads works, its scheduler decides.
std::optional<Library> tbb_flow_graph();
/// GStreamer: appsrc ! queue ! appsink.
std::optional<Library> gstreamer_queue();

}  // namespace svchain::bench
