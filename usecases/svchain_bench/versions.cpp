#include "usecases/svchain_bench/versions.h"

#include <algorithm>
#include <boost/asio/version.hpp>
#include <boost/version.hpp>
#include <hwy/highway.h>

#include "usecases/svchain_bench/library_hops.h"
#include "usecases/svchain_page/machine.h"

namespace svchain::bench {

namespace {

std::string of(const std::optional<Library>& library) {
  return library ? library->version : "not installed";
}

std::string asio_version() {
  return std::to_string(BOOST_ASIO_VERSION / 100000) + "." + std::to_string(BOOST_ASIO_VERSION / 100 % 1000) +
         "." + std::to_string(BOOST_ASIO_VERSION % 100);
}

std::string highway_version() {
  return std::to_string(HWY_MAJOR) + "." + std::to_string(HWY_MINOR) + "." + std::to_string(HWY_PATCH);
}

}  // namespace

Versions these_versions() {
  std::string boost = BOOST_LIB_VERSION;
  std::replace(boost.begin(), boost.end(), '_', '.');
  return {{"OpenCV", page::opencv_version()},
          {"Highway", highway_version()},
          {"asio", asio_version() + " of Boost " + boost},
          {"TBB", of(tbb_flow_graph())},
          {"GStreamer", of(gstreamer_queue())}};
}

}  // namespace svchain::bench
