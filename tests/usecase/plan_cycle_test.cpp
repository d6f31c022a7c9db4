#include "framework/usecase/plan.h"
#include "tests/catch.h"
#include "tests/usecase/expect.h"

namespace svchain {

namespace {

using testing::check_fault;
using testing::plan_faults;
using testing::plan_of;
using testing::text_of;

std::string joiner(const std::string& name) {
  return "\"" + name + R"(": {"type": "join", "core": "DSP1"})";
}
std::string doubler(const std::string& name) {
  return "\"" + name + R"(": {"type": "dup", "core": "DSP1"})";
}
const std::string kSource = R"("s": {"type": "capture", "core": "IPU1"})";
const std::string kSink = R"("n": {"type": "null", "core": "host"})";

}  // namespace

TEST_CASE("a cycle without feedback is a fault that names the whole of it") {
  const auto faults = plan_faults(
      text_of({kSource, joiner("a"), doubler("b"), kSink},
              {R"("s.front -> a.a")", R"("a.out -> b.in")", R"("b.out0 -> a.b")", R"("b.out1 -> n.in")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:9:1: error: /edges/2", {"a -> b -> a", "\"feedback\": true"});
}

TEST_CASE("a link that feeds itself is a cycle") {
  const auto faults = plan_faults(text_of(
      {kSource, joiner("a"), kSink}, {R"("s.front -> a.a")", R"("a.out -> a.b")", R"("s.rear -> n.in")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:7:1: error: /edges/1", {"a -> a;"});
}

TEST_CASE("each of two cycles is reported") {
  const auto faults = plan_faults(
      text_of({kSource, joiner("a"), doubler("b"), joiner("c"), doubler("d"), kSink},
              {R"("s.front -> a.a")", R"("a.out -> b.in")", R"("b.out0 -> a.b")", R"("b.out1 -> c.a")",
               R"("c.out -> d.in")", R"("d.out0 -> c.b")", R"("d.out1 -> n.in")"}));
  CHECK(faults.size() == 2);
  check_fault(faults, "", {"a -> b -> a"});
  check_fault(faults, "", {"c -> d -> c"});
}

TEST_CASE("a cycle whose closing edge is marked feedback is none") {
  const auto plan =
      plan_of(text_of({kSource, joiner("a"), doubler("b"), kSink},
                      {R"("s.front -> a.a")", R"("a.out -> b.in")",
                       R"({"from": "b.out0", "to": "a.b", "feedback": true})", R"("b.out1 -> n.in")"}));
  REQUIRE(plan);
  CHECK(plan->links[1].rank == 1);
  CHECK(plan->links[2].rank == 2);
  CHECK_FALSE(plan->edges[2].on_main_way);
}

TEST_CASE("an edge marked feedback that closes no cycle is a fault") {
  const auto faults =
      plan_faults(text_of({kSource, kSink}, {R"({"from": "s.front", "to": "n.in", "feedback": true})"}));
  CHECK(faults.size() == 1);
  check_fault(
      faults, "t.json:5:1: error: /edges/0",
      {"\"s.front -> n.in\" is marked feedback but closes no cycle", "\"s\" gets nothing from \"n\""});
}

}  // namespace svchain
