#include "framework/fault/fault_plan.h"

#include <tuple>

#include "tests/catch.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"

namespace svchain {

namespace {

using testing::check_fault;

Plan two_dsps() {
  auto plan = testing::plan_of(testing::kTwoDsps);
  REQUIRE(plan);
  return *std::move(plan);
}

Result<FaultPlan> place(const std::vector<std::string>& entries, const Plan& plan) {
  std::string text = "{\"faults\": [";
  for (const std::string& entry : entries) text += (text.back() == '[' ? "\n" : ",\n") + entry;
  const auto script = parse_fault_script(text + "]}", "f.json");
  if (!script) FAIL(script.error().front().text());
  return place_faults(*script, plan, 1);
}

PlannedFault placed(const std::string& kind, const std::string& at, const Plan& plan) {
  const auto result = place({R"({"kind": ")" + kind + R"(", "at": ")" + at + "\"}"}, plan);
  if (!result) FAIL(result.error().front().text());
  return result->faults.front();
}

Faults refused(const std::string& kind, const std::string& at, const Plan& plan) {
  const auto result = place({R"({"kind": ")" + kind + R"(", "at": ")" + at + "\"}"}, plan);
  REQUIRE_FALSE(result);
  return result.error();
}

}  // namespace

TEST_CASE("faults of links are placed by the link's name") {
  const Plan plan = two_dsps();
  const PlannedFault fault = placed("throw", "synthesis", plan);
  CHECK(plan.links[static_cast<size_t>(fault.place)].entry.name == "synthesis");
  CHECK(fault.at == "synthesis");
  check_fault(refused("throw", "sythesis", plan), "f.json:2:1: error: /faults/0",
              {R"(a fault "throw" needs a link, got "sythesis", did you mean "synthesis"? (known: capture)"});
  check_fault(refused("throw", "DSP1", plan), "", {R"(needs a link, got "DSP1")"});
}

TEST_CASE("faults of edges are placed by the edge's full name or by its output") {
  const Plan plan = two_dsps();
  const std::string name = "dup.out1 -> synthesis.frames";
  for (const std::string& at : {name, std::string("dup.out1")}) {
    const PlannedFault fault = placed("full", at, plan);
    CHECK(plan.edges[static_cast<size_t>(fault.place)].entry.name() == name);
    CHECK(fault.at == name);
  }
  CHECK(placed("lost", "photometric_alignment.tone_mapping", plan).at ==
        "photometric_alignment.tone_mapping -> synthesis.tone_mapping");
  check_fault(refused("lost", "dup.out2", plan), "",
              {R"(needs an edge, got "dup.out2", did you mean "dup.out)"});
  check_fault(refused("lost", "dup.out1 -> synthesis.lut", plan), "",
              {"did you mean \"dup.out1 -> synthesis.frames\"?"});
}

TEST_CASE("faults of what a source gives are placed at the outputs of links without inputs only") {
  const Plan plan = two_dsps();
  for (const char* kind : {"dropout", "freeze", "corrupt"}) {
    const PlannedFault fault = placed(kind, "capture.left", plan);
    CHECK(plan.edges[static_cast<size_t>(fault.place)].entry.name() == "capture.left -> sync.left");
    CHECK(fault.at == "capture.left");
    CHECK(placed(kind, "capture.left -> sync.left", plan).place == fault.place);
    check_fault(refused(kind, "synthesis.view", plan), "",
                {"needs an output of a source, got \"synthesis.view\"",
                 "(known: capture.front, capture.right, capture.rear or capture.left)"});
  }
}

TEST_CASE("cores halt by their name or their role, if anything runs on them") {
  const Plan plan = two_dsps();
  CHECK(plan.cores[static_cast<size_t>(placed("halt", "DSP2", plan).place)].name == "DSP2");
  CHECK(plan.cores[static_cast<size_t>(placed("halt", "host", plan).place)].name == "A15");
  CHECK(placed("halt", "host", plan).at == "A15");
  check_fault(refused("halt", "DSP3", plan), "",
              {R"(needs a core in use, got "DSP3", did you mean "DSP1"? (known: A15, IPU1, DSP1 or DSP2))"});
  const auto small = testing::plan_of(testing::text_of(
      {R"("a": {"type": "capture", "core": "IPU1"})", R"("b": {"type": "null", "core": "IPU1"})"},
      {R"("a.front -> b.in")"}));
  REQUIRE(small);
  check_fault(refused("halt", "host", *small), "", {R"(needs a core in use, got "host" (known: IPU1))"});
}

TEST_CASE("only links with buffers of their own run out of memory") {
  const Plan plan = two_dsps();
  CHECK(placed("no_memory", "geometric_alignment", plan).at == "geometric_alignment");
  for (const char* link : {"dup", "sync", "display"}) {
    check_fault(
        refused("no_memory", link, plan), "",
        {"needs a link with buffers of its own", "(known: capture, geometric_alignment, synthesis or"});
  }
}

TEST_CASE("the clock has no place, and amounts and times are nanoseconds") {
  const Plan plan = two_dsps();
  const auto result = place(
      {R"({"kind": "late", "at": "dup.out1", "from_s": 2.5, "to_s": 3, "late_ms": 1.5, "chance": 0.25})",
       R"({"kind": "clock_step", "from_s": 1, "step_ms": -100})",
       R"({"kind": "slow", "at": "dup", "factor": 3, "extra_ms": 2})"},
      plan);
  REQUIRE(result);
  REQUIRE(result->faults.size() == 3);
  const auto& [slow, clock, late] =
      std::tie(result->faults[0], result->faults[1], result->faults[2]);  // by beginning
  CHECK(slow.kind == FaultKind::kSlow);
  CHECK(slow.factor == 3);
  CHECK(slow.amount_ns == 2'000'000);
  CHECK(clock.place == -1);
  CHECK(clock.amount_ns == -100'000'000);
  CHECK(clock.to_ns == PlannedFault::kNever);
  CHECK(late.from_ns == 2'500'000'000);
  CHECK(late.to_ns == 3'000'000'000);
  CHECK(late.amount_ns == 1'500'000);
  CHECK(late.chance == 0.25);
}

TEST_CASE("all unknown places are told at once, each at its entry") {
  const auto result = place({R"({"kind": "halt", "at": "DPS1"})", R"({"kind": "halt", "at": "DSP1"})",
                             R"({"kind": "lost", "at": "sync.frame -> dup.in"})"},
                            two_dsps());
  REQUIRE_FALSE(result);
  CHECK(result.error().size() == 2);
  check_fault(result.error(), "f.json:2:1: error: /faults/0", {"did you mean \"DSP1\"?"});
  check_fault(result.error(), "f.json:4:1: error: /faults/2", {"did you mean \"sync.frames -> dup.in\"?"});
}

TEST_CASE("the shipped failing parts are parts of 2dsv_2dsp") {
  const auto script =
      read_fault_script(testing::project_folder() / "configs" / "faults" / "failing_parts.json");
  REQUIRE(script);
  const auto plan = place_faults(*script, two_dsps(), 1);
  if (!plan) FAIL(plan.error().front().text());
  CHECK(plan->faults.size() == kFaultKinds - 1);  // none that would end the run
  CHECK(plan->faults.front().from_ns == 8'000'000'000);
}

}  // namespace svchain
