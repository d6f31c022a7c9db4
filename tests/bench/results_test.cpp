#include "usecases/svchain_bench/results.h"

#include <nlohmann/json.hpp>

#include "tests/catch.h"

using namespace svchain::bench;

TEST_CASE("what was not measured is null, and every name of the contract is there") {
  const auto json = json_of({}, {"a machine", "a compiler", "4.6.0"});
  CHECK(json["machine"] == "a machine");
  CHECK(json["compiler"] == "a compiler");
  CHECK(json["opencv"] == "4.6.0");
  for (const char* name :
       {"synthesis.portable.1t", "synthesis.avx2.1t", "synthesis.avx512.1t", "synthesis.avx512.2t",
        "synthesis.nv12.avx512.1t", "chain.frames_vs_kernels", "hop.spin_park_rtt_over_raw_ring",
        "hop.parked_rtt_over_raw_futex", "hop.stream_vs_asio_post", "hop.stream_vs_gstreamer_queue"}) {
    INFO(name);
    REQUIRE(json["ratios"].contains(name));
    CHECK(json["ratios"][name].is_null());
  }
  for (const char* name :
       {"hop.same_core_ns", "bowl.gpu_fps", "bowl.cpu_moving_fps", "bowl.cpu_static_over_2d"}) {
    INFO(name);
    REQUIRE(json["figures"].contains(name));
    CHECK(json["figures"][name].is_null());
  }
}

TEST_CASE("what a library would be needed for is null where that is not installed") {
  Results results;
  results.missing["hop.stream_vs_tbb_flow_graph"] = "not installed";
  const auto json = json_of(results, {});
  REQUIRE(json["ratios"].contains("hop.stream_vs_tbb_flow_graph"));
  CHECK(json["ratios"]["hop.stream_vs_tbb_flow_graph"].is_null());
}

TEST_CASE("what was measured is there with its quartiles and the costs of both sides, to four digits") {
  Results results;
  results.ratios["hop.stream_vs_asio_post"] = {3.14159, 2.5, 4, 600, 191.23456};
  results.figures["hop.same_core_ns"] = 98765.4;
  const auto json = json_of(results, {});
  CHECK(json["ratios"]["hop.stream_vs_asio_post"] == 3.142);
  CHECK(json["quartiles"]["hop.stream_vs_asio_post"] == nlohmann::json{2.5, 4.0});
  CHECK(json["costs"]["hop.stream_vs_asio_post"] == nlohmann::json{600.0, 191.2});
  CHECK(json["figures"]["hop.same_core_ns"] == 98770);
}

TEST_CASE("the machine, the compiler and OpenCV have names") {
  const Machine machine = this_machine();
  CHECK_FALSE(machine.processor.empty());
  CHECK(machine.compiler.starts_with("g++ "));
  CHECK_FALSE(machine.opencv.empty());
}
