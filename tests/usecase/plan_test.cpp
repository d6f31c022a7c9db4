#include "framework/usecase/plan.h"

#include "tests/catch.h"
#include "tests/usecase/expect.h"

namespace svchain {

namespace {

using testing::check_fault;
using testing::plan_faults;
using testing::plan_of;
using testing::text_of;

const std::string kCapture = R"("capture": {"type": "capture", "core": "IPU1"})";
const std::string kGain = R"("gain": {"type": "gain", "core": "DSP1"})";
const std::string kDisplay = R"("display": {"type": "display", "core": "host"})";

const PlannedLink& link(const Plan& plan, const std::string& name) {
  for (const PlannedLink& planned : plan.links) {
    if (planned.entry.name == name) return planned;
  }
  throw std::logic_error("no link " + name);
}

const PlannedEdge& edge(const Plan& plan, const std::string& name) {
  for (const PlannedEdge& planned : plan.edges) {
    if (planned.entry.name() == name) return planned;
  }
  throw std::logic_error("no edge " + name);
}

Plan two_dsps() {
  auto plan = plan_of(testing::kTwoDsps);
  if (!plan) FAIL(plan.error().front().text());
  return std::move(*plan);
}

}  // namespace

TEST_CASE("a plan lists the cores that are used, in the SoC's order, and resolves roles") {
  const Plan plan = two_dsps();
  std::vector<std::string> cores;
  for (const auto& core : plan.cores) cores.push_back(core.name);
  CHECK(cores == std::vector<std::string>{"A15", "IPU1", "DSP1", "DSP2"});
  CHECK(plan.cores[static_cast<size_t>(link(plan, "display").core)].name == "A15");
  CHECK(plan.cores[static_cast<size_t>(link(plan, "synthesis").core)].name == "DSP2");
}

TEST_CASE("a use case gives cores more CPUs than their SoC does, by name or role") {
  std::string text = testing::kTwoDsps;
  text.insert(text.find('{') + 1, R"("cpus": {"DSP2": 2, "host": 3},)");
  const auto plan = plan_of(text);
  if (!plan) FAIL(plan.error().front().text());
  const auto cpus = [&](const std::string& of) {
    return plan->cores[static_cast<size_t>(link(*plan, of).core)].cpus;
  };
  CHECK(cpus("synthesis") == 2);
  CHECK(cpus("display") == 3);
  CHECK(cpus("capture") == 1);
}

TEST_CASE("CPUs of a core that the SoC has not are a fault that names the nearest") {
  std::string text = testing::kTwoDsps;
  text.insert(text.find('{') + 1, R"("cpus": {"DPS1": 2},)");
  const auto plan = plan_of(text);
  REQUIRE_FALSE(plan);
  CHECK(plan.error().size() == 1);
  check_fault(plan.error(), "t.json:1:19: error: /cpus/DPS1",
              {"has no core \"DPS1\"", "did you mean \"DSP1\"?"});
}

TEST_CASE("an edge between cores becomes an IPC pair, one within a core does not") {
  const Plan plan = two_dsps();
  CHECK_FALSE(edge(plan, "sync.frames -> dup.in").ipc);
  CHECK(edge(plan, "dup.out0 -> geometric_alignment.frames").ipc);
  CHECK(edge(plan, "synthesis.statistics -> photometric_alignment.statistics").ipc);
  CHECK(edge(plan, "photometric_alignment.tone_mapping -> synthesis.tone_mapping").ipc);
}

TEST_CASE("links are ordered from source to sink") {
  const Plan plan = two_dsps();
  CHECK(link(plan, "capture").rank == 0);
  CHECK(link(plan, "dup").rank == 2);
  CHECK(link(plan, "synthesis").rank == 4);
  CHECK(link(plan, "photometric_alignment").rank == 5);
  REQUIRE(plan.source_to_sink.size() == 7);
  for (size_t i = 1; i < plan.source_to_sink.size(); ++i) {
    CHECK(plan.links[static_cast<size_t>(plan.source_to_sink[i - 1])].rank <=
          plan.links[static_cast<size_t>(plan.source_to_sink[i])].rank);
  }
}

TEST_CASE("the main way is that of the frames to the display") {
  const Plan plan = two_dsps();
  for (const char* name : {"capture", "sync", "dup", "synthesis", "display"})
    CHECK(link(plan, name).on_main_way);
  for (const char* name : {"geometric_alignment", "photometric_alignment"})
    CHECK_FALSE(link(plan, name).on_main_way);
  CHECK(edge(plan, "dup.out1 -> synthesis.frames").on_main_way);
  CHECK_FALSE(edge(plan, "dup.out0 -> geometric_alignment.frames").on_main_way);
  CHECK_FALSE(edge(plan, "geometric_alignment.lut -> synthesis.lut").on_main_way);
}

TEST_CASE("where nothing delivers, the main way leads to every sink") {
  const auto plan = plan_of(text_of(
      {kCapture, R"("x": {"type": "null", "core": "DSP1"})", R"("y": {"type": "null", "core": "DSP1"})"},
      {R"("capture.front -> x.in")", R"("capture.rear -> y.in")"}));
  REQUIRE(plan);
  for (const auto& planned : plan->links) CHECK(planned.on_main_way);
  for (const auto& planned : plan->edges) CHECK(planned.on_main_way);
}

TEST_CASE("ports know their edges") {
  const Plan plan = two_dsps();
  const PlannedLink& dup = link(plan, "dup");
  CHECK(dup.input_edges == std::vector<int>{4});
  CHECK(dup.output_edges == std::vector<int>{5, 6, -1});
}

TEST_CASE("a core that the SoC lacks is a fault that lists what it has") {
  const auto faults = plan_faults(text_of({R"("capture": {"type": "capture", "core": "EVE1"})", kDisplay},
                                          {R"("capture.front -> display.frames")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:2:40: error: /links/capture/core",
              {"\"tda2x\" has no core \"EVE1\"", "A15, IPU1, DSP1, DSP2 or host"});
  check_fault(plan_faults(text_of({R"("capture": {"type": "capture", "core": "hots"})", kDisplay},
                                  {R"("capture.front -> display.frames")"})),
              "", {"did you mean \"host\"?"});
}

TEST_CASE("an unknown port is one fault that names the nearest and lists the ports") {
  const auto faults = plan_faults(text_of({kCapture, kDisplay}, {R"("capture.fornt -> display.frame")"}));
  CHECK(faults.size() == 2);
  check_fault(
      faults, "t.json:5:1: error: /edges/0",
      {"\"capture.fornt\" is no output", "did you mean \"front\"?", "(outputs: front, right, rear or left)"});
  check_fault(faults, "t.json:5:1: error: /edges/0",
              {"\"display.frame\" is no input", "did you mean \"frames\"?", "(inputs: frames)"});
}

TEST_CASE("an edge the wrong way round is a fault that says so") {
  const auto faults = plan_faults(text_of(
      {kCapture, kGain, kDisplay}, {R"("capture.front -> gain.in")", R"("gain.in -> display.frames")"}));
  check_fault(faults, "t.json:7:1: error: /edges/1",
              {"\"gain.in\" is an input, expected an output", "(outputs: out)"});
  check_fault(plan_faults(text_of({kCapture, kDisplay}, {R"("display.frames -> capture.front")"})), "",
              {"\"capture.front\" is an output, expected an input", "\"capture\" has no inputs"});
}

TEST_CASE("two edges into one input are a fault that names the first") {
  const auto faults = plan_faults(text_of(
      {kCapture, kDisplay}, {R"("capture.front -> display.frames")", R"("capture.rear -> display.frames")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:6:1: error: /edges/1",
              {"the input \"display.frames\" takes one edge only", "\"capture.front -> display.frames\""});
}

TEST_CASE("two edges out of one output are a fault that advises a dup link") {
  const auto faults =
      plan_faults(text_of({kCapture, kDisplay, R"("null": {"type": "null", "core": "host"})"},
                          {R"("capture.front -> display.frames")", R"("capture.front -> null.in")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:7:1: error: /edges/1",
              {"the output \"capture.front\" feeds one edge only: use a dup link"});
}

TEST_CASE("a required input that nothing feeds is a fault of its link, an optional one is not") {
  const auto faults = plan_faults(text_of({kCapture, R"("join": {"type": "join", "core": "DSP1"})", kDisplay},
                                          {R"("join.out -> display.frames")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:3:9: error: /links/join",
              {"no edge leads to the input \"join.a\", which is required"});
}

TEST_CASE("formats that differ are a fault that names both ports and the field") {
  const auto faults = plan_faults(text_of(
      {kCapture, R"("photometric_alignment": {"type": "photometric_alignment", "core": "DSP1"})", kDisplay},
      {R"("capture.front -> photometric_alignment.statistics")",
       R"("photometric_alignment.tone_mapping -> display.frames")"}));
  CHECK(faults.size() == 2);
  check_fault(faults, "t.json:6:1: error: /edges/0",
              {"formats differ: \"capture.front\" gives type bgr8 or nv12, "
               "\"photometric_alignment.statistics\" takes type "
               "overlap_statistics"});
  check_fault(
      faults, "t.json:7:1: error: /edges/1",
      {"\"photometric_alignment.tone_mapping\" gives type tone_mapping, \"display.frames\" takes type bgr8"});
}

TEST_CASE("a set where one frame is expected is a fault of the count") {
  const auto faults =
      plan_faults(text_of({kCapture, R"("g": {"type": "geometric_alignment", "core": "DSP1"})",
                           R"("n": {"type": "null", "core": "host"})"},
                          {R"("capture.front -> g.frames")", R"("g.lut -> n.in")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:6:1: error: /edges/0",
              {"\"capture.front\" gives buffers 1, \"g.frames\" takes buffers 4"});
}

TEST_CASE("what a dup or a sync hands on is checked like what it got") {
  const std::string dup = R"("dup": {"type": "dup", "core": "IPU1"})";
  check_fault(
      plan_faults(text_of(
          {kCapture, dup, R"("p": {"type": "photometric_alignment", "core": "DSP1"})",
           R"("n": {"type": "null", "core": "host"})"},
          {R"("capture.front -> dup.in")", R"("dup.out0 -> p.statistics")", R"("p.tone_mapping -> n.in")"})),
      "t.json:8:1: error: /edges/1", {"\"dup.out0\" gives type bgr8 or nv12, \"p.statistics\" takes"});
  check_fault(plan_faults(text_of({kCapture, R"("sync": {"type": "sync", "core": "IPU1"})", dup, kDisplay},
                                  {R"("capture.front -> sync.front")", R"("capture.right -> sync.right")",
                                   R"("capture.rear -> sync.rear")", R"("capture.left -> sync.left")",
                                   R"("sync.frames -> dup.in")", R"("dup.out2 -> display.frames")"})),
              "t.json:12:1: error: /edges/5",
              {"\"dup.out2\" gives buffers 4, \"display.frames\" takes buffers 1"});
}

TEST_CASE("a use case without a source or without a sink is a fault") {
  const auto sourceless = plan_faults(text_of({R"("join": {"type": "join", "core": "DSP1"})", kDisplay},
                                              {R"("join.out -> display.frames")"}));
  check_fault(sourceless, "t.json:1:40: error: /links", {"no source"});
  const auto sinkless = plan_faults(text_of({kCapture, kGain}, {R"("capture.front -> gain.in")"}));
  CHECK(sinkless.size() == 1);
  check_fault(sinkless, "t.json:1:40: error: /links", {"no sink", "display or null"});
}

TEST_CASE("links that no frame reaches are one fault for each group") {
  const auto faults = plan_faults(
      text_of({kCapture, kDisplay, R"("x": {"type": "join", "core": "DSP1"})",
               R"("y": {"type": "dup", "core": "DSP1"})", R"("z": {"type": "null", "core": "DSP1"})"},
              {R"("capture.front -> display.frames")", R"("x.out -> y.in")",
               R"({"from": "y.out0", "to": "x.a", "feedback": true})", R"("y.out1 -> z.in")"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:4:6: error: /links/x",
              {"no frame ever reaches \"x\"", "from a source (capture)"});
}

TEST_CASE("all faults of a plan are reported at once") {
  const auto faults =
      plan_faults(text_of({R"("capture": {"type": "capture", "core": "DSP9"})", kGain, kDisplay},
                          {R"("capture.back -> gain.in")", R"("gain.out -> display.frame")"}));
  CHECK(faults.size() == 3);
}

}  // namespace svchain
