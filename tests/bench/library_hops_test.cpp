#include "usecases/svchain_bench/library_hops.h"

#include <algorithm>

#include "tests/catch.h"
#include "usecases/svchain_bench/versions.h"

using namespace svchain::bench;

namespace {

std::string version_of(const std::string& name) {
  for (const auto& [library, version] : these_versions())
    if (library == name) return version;
  return "";
}

}  // namespace

// What takes the messages throws where one is lost or comes out of order.
TEST_CASE("the libraries that are installed deliver every message in order") {
  constexpr int kMessages = 3000;
  if (const auto tbb = tbb_flow_graph()) {
    CHECK(tbb->stream_ns(kMessages) > 0);
    CHECK(tbb->line_ns(1, kMessages) > 0);
    CHECK(tbb->line_ns(16, kMessages) > 0);
  }
  if (const auto gstreamer = gstreamer_queue()) CHECK(gstreamer->stream_ns(kMessages) > 0);
}

TEST_CASE("libraries are named with their versions, or said not to be installed") {
  CHECK((version_of("TBB") == "not installed") == !tbb_flow_graph());
  CHECK((version_of("GStreamer") == "not installed") == !gstreamer_queue());
  for (const char* name : {"OpenCV", "Highway", "asio"}) {
    INFO(name);
    CHECK(version_of(name).find('.') != std::string::npos);
  }
}
