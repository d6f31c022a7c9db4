#include <cmath>
#include <memory>

#include "framework/testing/harness.h"
#include "links/dup.h"
#include "links/gate.h"
#include "links/merge.h"
#include "links/null.h"
#include "links/null_source.h"
#include "links/select.h"
#include "tests/catch.h"
#include "tests/links/pictures.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

const Format kPicture = Format::bgr8(4, 2);

/// Writes the number of the buffer into each.
void number_buffers(int buffer, std::span<std::byte> bytes) {
  bytes[0] = static_cast<std::byte>(buffer);
}

}  // namespace

TEST_CASE("dup hands the same pixels to every output that is connected") {
  LinkHarness dup(make_dup());
  dup.input("in", {kPicture});
  for (const char* port : {"out1", "out3", "out4", "out5"}) dup.disconnect(port);
  REQUIRE(dup.configure().empty());
  dup.push("in", {.sequence = 5});
  dup.run();
  const auto a = dup.pop("out0"), b = dup.pop("out2");
  REQUIRE((a && b));
  CHECK(a->bytes().data() == b->bytes().data());
  CHECK(b->sequence() == 5);
}

TEST_CASE("merge joins what carries the same sequence number, in the order of the inputs") {
  LinkHarness merge(make_merge());
  merge.input("in0", {kPicture});
  merge.input("in2", {kPicture, Format::bgr8(8, 8)});
  REQUIRE(merge.configure().empty());
  CHECK(merge.output_format("frames") == PortFormat{kPicture, kPicture, Format::bgr8(8, 8)});
  merge.push("in0", {.sequence = 1});
  merge.run();
  CHECK(!merge.pop("frames"));
  merge.push("in2", {.sequence = 1});
  merge.run();
  const auto set = merge.pop("frames");
  REQUIRE(set);
  CHECK(set->count() == 3);
  CHECK(set->format(2).width_px == 8);
}

TEST_CASE("merge drops what has no counterpart and goes on with the next set") {
  LinkHarness merge(make_merge());
  merge.input("in0", {kPicture});
  merge.input("in1", {kPicture});
  REQUIRE(merge.configure().empty());
  for (uint64_t n : {0, 1, 2, 3}) merge.push("in0", {.sequence = n});
  for (uint64_t n : {0, 2, 3, 4}) merge.push("in1", {.sequence = n});
  merge.run();
  for (uint64_t n : {0, 2, 3}) {
    merge.pop_absence("frames");
    const auto set = merge.pop("frames");
    REQUIRE(set);
    CHECK(set->sequence() == n);
  }
  CHECK(merge.dropped()["unmatched"] == 1);
}

TEST_CASE("merge without any input is a fault") {
  LinkHarness merge(make_merge());
  CHECK_THAT(text_of(merge.configure()), Contains("none of in0, in1, in2 and in3"));
}

TEST_CASE("select hands on the chosen buffers in the chosen order") {
  LinkHarness select(make_select());
  select.parameter("buffers", {2, 0});
  select.input("in", {kPicture, kPicture, kPicture});
  REQUIRE(select.configure().empty());
  select.push("in", {.sequence = 3, .timestamp_ns = 9, .write = number_buffers});
  select.run();
  const auto chosen = select.pop("out");
  REQUIRE(chosen);
  CHECK(chosen->count() == 2);
  CHECK(chosen->sequence() == 3);
  CHECK(chosen->bytes(0)[0] == std::byte{2});
  CHECK(chosen->bytes(1)[0] == std::byte{0});
}

TEST_CASE("select faults a buffer that the set does not have") {
  const double buffer = GENERATE(3.0, 0.5);
  LinkHarness select(make_select());
  select.parameter("buffers", {buffer});
  select.input("in", {kPicture, kPicture, kPicture});
  CHECK_THAT(text_of(select.configure()), Contains("buffers") && Contains("expected 0 to 2"));
}

TEST_CASE("a gate drops and counts while it is closed, and can be opened on the way") {
  LinkHarness gate(make_gate());
  gate.parameter("open", false);
  gate.input("in", {kPicture});
  REQUIRE(gate.configure().empty());
  gate.push("in", {.sequence = 0});
  gate.run();
  CHECK(!gate.pop("out"));
  CHECK(gate.dropped()["gate_closed"] == 1);
  gate.link().control("open", {});
  gate.pop_absence("out");
  gate.push("in", {.sequence = 1});
  gate.run();
  CHECK(gate.pop("out")->sequence() == 1);
  CHECK_THROWS_WITH(gate.link().control("ajar", {}), Contains("ajar") && Contains("open or close"));
}

TEST_CASE("null swallows everything") {
  LinkHarness null(make_null());
  null.input("in", {kPicture});
  REQUIRE(null.configure().empty());
  for (uint64_t n = 0; n < 200; ++n) {
    null.push("in", {.sequence = n});  // fails as soon as a buffer is kept
    null.run();
  }
  CHECK(null.processed() == 200);
}

TEST_CASE("a null source makes as many sets as it is told, always of the same buffers") {
  LinkHarness source(make_null_source());
  source.parameter("count", 5);
  source.parameter("width", 10);
  source.parameter("height", 4);
  source.parameter("buffers", 4);
  REQUIRE(source.configure().empty());
  CHECK(source.output_format("frames") == PortFormat(4, Format::bgr8(10, 4)));
  source.run();
  CHECK(source.captured() == 5);
  for (uint64_t n = 0; n < 5; ++n) {
    const auto set = source.pop("frames");
    REQUIRE(set);
    CHECK(set->sequence() == n);
    CHECK(set->timestamp_ns(3) == std::llround(static_cast<double>(n) * 1e9 / 30));
  }
  CHECK(source.pop_end("frames"));
  source.stop();
  CHECK(source.buffers_in_use() == 0);
}

TEST_CASE("a null source in real time drops what finds no room") {
  LinkHarness source(make_null_source());
  source.pace.real_time = source.pace.virtual_clock = true;
  source.pace.fps = 100;
  source.pace.frames = 3;
  source.output_depth("frames", 1);
  REQUIRE(source.configure().empty());
  for (int tick = 0; tick < 3; ++tick) {
    source.clock().advance_to(tick * 10'000'000);
    source.run();
  }
  CHECK(source.captured() == 3);
  CHECK(source.dropped()["downstream_full"] == 2);
}
