#pragma once
// What library_hops.h says of GStreamer; there only where GStreamer is.

#include <string>

namespace svchain::bench {

std::string gstreamer_version();
double gstreamer_stream_ns(int messages);

}  // namespace svchain::bench
