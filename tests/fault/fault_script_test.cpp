#include "framework/fault/fault_script.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/catch.h"
#include "tests/json_schema.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"

namespace svchain {

namespace {

using testing::check_fault;

std::string script_of(const std::string& entry) {
  return "{\"faults\": [\n" + entry + "]}";
}

std::string random_of(const std::string& members) {
  return "{\"random\": {\n" + members + "}}";
}

FaultEntry entry_of(const std::string& entry) {
  const auto script = parse_fault_script(script_of(entry), "f.json");
  if (!script) FAIL(script.error().front().text());
  REQUIRE(script->entries.size() == 1);
  return script->entries.front();
}

RandomFaults random_faults_of(const std::string& members) {
  const auto script = parse_fault_script(random_of(members), "f.json");
  if (!script) FAIL(script.error().front().text());
  REQUIRE(script->random);
  return *script->random;
}

Faults faults_of(const std::string& text) {
  const auto script = parse_fault_script(text, "f.json");
  REQUIRE_FALSE(script);
  return script.error();
}

/// One of each kind, as short as it may be.
const std::vector<std::pair<FaultKind, std::string>> kShortest = {
    {FaultKind::kDropout, R"({"kind": "dropout", "at": "a.b"})"},
    {FaultKind::kFreeze, R"({"kind": "freeze", "at": "a.b"})"},
    {FaultKind::kJitter, R"({"kind": "jitter", "at": "a.b", "jitter_ms": 2.5})"},
    {FaultKind::kWrongTimestamp, R"({"kind": "wrong_timestamp", "at": "a.b", "shift_ms": -20})"},
    {FaultKind::kCorrupt, R"({"kind": "corrupt", "at": "a.b"})"},
    {FaultKind::kSlow, R"({"kind": "slow", "at": "a", "factor": 2})"},
    {FaultKind::kThrow, R"({"kind": "throw", "at": "a"})"},
    {FaultKind::kNoMemory, R"({"kind": "no_memory", "at": "a"})"},
    {FaultKind::kLost, R"({"kind": "lost", "at": "a.b -> c.d"})"},
    {FaultKind::kLate, R"({"kind": "late", "at": "a.b -> c.d", "late_ms": 40})"},
    {FaultKind::kFull, R"({"kind": "full", "at": "a.b -> c.d"})"},
    {FaultKind::kHalt, R"({"kind": "halt", "at": "DSP1"})"},
    {FaultKind::kClockStep, R"({"kind": "clock_step", "step_ms": -100})"}};

std::string with(const std::string& entry, const std::string& member) {
  return entry.substr(0, entry.size() - 1) + ", " + member + "}";
}

/// Texts that the reader refuses, and a JSON Schema can refuse as well.
const std::vector<std::string> kRefused = {
    "[]",
    "{}",
    R"({"faults": {}})",
    R"({"faults": [], "Random": {}})",
    script_of("3"),
    script_of(R"({"at": "a.b"})"),
    script_of(R"({"kind": "halts", "at": "DSP1"})"),
    script_of(R"({"kind": "halt"})"),
    script_of(R"({"kind": "halt", "at": 1})"),
    script_of(R"({"kind": "halt", "at": "DSP1", "from_s": -1})"),
    script_of(R"({"kind": "halt", "at": "DSP1", "to_s": 0})"),
    script_of(R"({"kind": "halt", "at": "DSP1", "to_s": 1000001})"),
    script_of(R"({"kind": "lost", "at": "a.b", "chance": 0})"),
    script_of(R"({"kind": "lost", "at": "a.b", "chance": 1.01})"),
    script_of(R"({"kind": "jitter", "at": "a.b"})"),
    script_of(R"({"kind": "jitter", "at": "a.b", "jitter_ms": 0})"),
    script_of(R"({"kind": "jitter", "at": "a.b", "jitter_ms": 1001})"),
    script_of(R"({"kind": "wrong_timestamp", "at": "a.b", "shift_ms": 0})"),
    script_of(R"({"kind": "late", "at": "a.b", "late_ms": -1})"),
    script_of(R"({"kind": "late", "at": "a.b", "late_ms": 60001})"),
    script_of(R"({"kind": "slow", "at": "a"})"),
    script_of(R"({"kind": "slow", "at": "a", "factor": 0.5})"),
    script_of(R"({"kind": "slow", "at": "a", "extra_ms": -1})"),
    script_of(R"({"kind": "clock_step", "at": "clock", "step_ms": 1})"),
    script_of(R"({"kind": "clock_step", "step_ms": 0})"),
    script_of(R"({"kind": "clock_step"})"),
    random_of(R"("per_hour": 60)"),
    random_of(R"("to_s": 60)"),
    random_of(R"("per_hour": 0, "to_s": 60)"),
    random_of(R"("per_hour": 3601, "to_s": 60)"),
    random_of(R"("per_hour": 60, "to_s": 60, "lasting_s": [1])"),
    random_of(R"("per_hour": 60, "to_s": 60, "lasting_s": [0, 1])"),
    random_of(R"("per_hour": 60, "to_s": 60, "kinds": [])"),
    random_of(R"("per_hour": 60, "to_s": 60, "kinds": ["halt", "halt"])"),
    random_of(R"("per_hour": 60, "to_s": 60, "kinds": ["rust"])"),
    random_of(R"("per_hour": 60, "to_s": 60, "kind": ["halt"])")};

}  // namespace

TEST_CASE("a fault of every kind is read, from the start to the end of the run where no times are given") {
  REQUIRE(kShortest.size() == kFaultKinds);
  for (const auto& [kind, text] : kShortest) {
    INFO(text);
    const FaultEntry entry = entry_of(text);
    CHECK(entry.kind == kind);
    CHECK(text.find(name_of(entry.kind)) != std::string::npos);
    CHECK(entry.at.empty() == (kind == FaultKind::kClockStep));
    CHECK(entry.from_s == 0);
    CHECK(std::isinf(entry.to_s));
    CHECK(entry.chance == 1);
    CHECK(entry.origin.where.line == 2);
  }
}

TEST_CASE("amounts, times and chances of a fault are read") {
  CHECK(entry_of(kShortest[2].second).amount_ms == 2.5);
  CHECK(entry_of(kShortest[3].second).amount_ms == -20);
  CHECK(entry_of(kShortest[9].second).amount_ms == 40);
  CHECK(entry_of(kShortest[12].second).amount_ms == -100);
  CHECK(entry_of(kShortest[5].second).factor == 2);
  CHECK(entry_of(R"({"kind": "slow", "at": "a", "extra_ms": 5})").factor == 1);
  CHECK(entry_of(R"({"kind": "slow", "at": "a", "extra_ms": 5})").amount_ms == 5);
  const FaultEntry lost =
      entry_of(R"({"kind": "lost", "at": "a.b -> c.d", "from_s": 2, "to_s": 3.5, "chance": 0.1})");
  CHECK(lost.at == "a.b -> c.d");
  CHECK(lost.from_s == 2);
  CHECK(lost.to_s == 3.5);
  CHECK(lost.chance == 0.1);
}

TEST_CASE("random faults are of all kinds and last 0.05 to 2 s where nothing else is said") {
  const RandomFaults usual = random_faults_of(R"("per_hour": 60, "to_s": 3600)");
  CHECK(usual.per_hour == 60);
  CHECK(usual.from_s == 0);
  CHECK(usual.to_s == 3600);
  CHECK(usual.lasting_s == std::array<double, 2>{0.05, 2});
  CHECK(usual.kinds.size() == kFaultKinds);
  const RandomFaults some = random_faults_of(
      R"("per_hour": 6, "from_s": 10, "to_s": 20, "lasting_s": [1, 1], "kinds": ["late", "halt"])");
  CHECK(some.from_s == 10);
  CHECK(some.lasting_s == std::array<double, 2>{1, 1});
  CHECK(some.kinds == std::vector<FaultKind>{FaultKind::kLate, FaultKind::kHalt});
}

TEST_CASE("a key of another kind of fault is refused, with those that this kind has") {
  check_fault(faults_of(script_of(R"({"kind": "halt", "at": "DSP1", "late_ms": 1})")),
              "f.json:2:43: error: /faults/0/late_ms",
              {R"(the fault "halt" has no "late_ms" (known: kind, at, from_s or to_s))"});
  check_fault(faults_of(script_of(R"({"kind": "clock_step", "at": "clock", "step_ms": 1})")),
              "f.json:2:30: error: /faults/0/at", {R"(has no "at" (known: kind, from_s, to_s or step_ms))"});
  for (const char* kind : {"freeze", "no_memory", "full", "halt"}) {
    check_fault(faults_of(script_of(
                    with(R"({"kind": ")" + std::string(kind) + R"(", "at": "a"})", R"("chance": 0.5)"))),
                "", {"the fault \"" + std::string(kind) + "\" has no \"chance\""});
  }
  check_fault(faults_of(script_of(with(kShortest[5].second, R"("chance": 0.5)"))), "",
              {R"(the fault "slow" has no "chance")"});
  check_fault(faults_of(script_of(with(kShortest[12].second, R"("chance": 0.5)"))), "",
              {R"(the fault "clock_step" has no "chance")"});
}

TEST_CASE("all faults of a fault file are told at once, each with its place") {
  const auto faults = faults_of(
      "{\"faults\": [\n{\"kind\": \"drop_out\", \"at\": 3},\n"
      "{\"kind\": \"lost\", \"form_s\": 2, \"chance\": 0},\n"
      "{\"kind\": \"halt\", \"at\": \"DSP1\", \"from_s\": 3, \"to_s\": 3}],\n"
      "\"random\": {\"per_hour\": -1, \"from_s\": 5, \"to_s\": 4, \"lasting_s\": [2, 1], \"kinds\": "
      "[\"late\", \"lat\", \"late\"]}}");
  CHECK(faults.size() == 10);
  check_fault(faults, "f.json:2:10: error: /faults/0/kind", {R"(got "drop_out", did you mean "dropout"?)"});
  check_fault(faults, "f.json:3:28: error: /faults/1/form_s", {R"(unknown key, did you mean "from_s"?)"});
  check_fault(faults, "f.json:3:41: error: /faults/1/chance", {"expected 0 to 1 and not 0, got 0"});
  check_fault(faults, "f.json:3:1: error: /faults/1", {R"("at" is missing)"});
  check_fault(faults, "f.json:4:53: error: /faults/2/to_s", {R"(expected a time after "from_s")"});
  check_fault(faults, "", {"expected 0.001 to 3600 faults an hour, got -1"});
  check_fault(faults, "f.json:5:49: error: /random/to_s", {R"(expected a time after "from_s")"});
  check_fault(faults, "", {"expected the shortest and the longest time"});
  check_fault(faults, "", {R"(got "lat", did you mean "late"?)"});
  check_fault(faults, "", {R"("late" stands twice)"});
}

TEST_CASE("amounts that change nothing or are beyond reason are refused with their range and unit") {
  const auto said = [](const std::string& entry) { return faults_of(script_of(entry)); };
  check_fault(said(R"({"kind": "jitter", "at": "a.b", "jitter_ms": 0})"), "", {"0 to 1000 ms and not 0"});
  check_fault(said(R"({"kind": "clock_step", "step_ms": 0})"), "", {"ms and not 0, got 0"});
  check_fault(said(R"({"kind": "late", "at": "a.b", "late_ms": 1e5})"), "", {"expected 0 to 60000 ms"});
  check_fault(said(R"({"kind": "slow", "at": "a", "factor": 0.5})"), "", {"expected 1 to 1000, got 0.5"});
  check_fault(said(R"({"kind": "slow", "at": "a"})"), "f.json:2:1: error: /faults/0",
              {R"("factor" or "extra_ms" is missing)"});
  check_fault(said(R"({"kind": "jitter", "at": "a.b"})"), "", {R"("jitter_ms" is missing)"});
}

TEST_CASE("a fault file has faults, or random ones, or both") {
  check_fault(faults_of("{}"), "f.json:1:1: error", {R"("faults" or "random" is missing)"});
  CHECK(parse_fault_script(R"({"$schema": "x", "faults": [], "random": {"per_hour": 1, "to_s": 1}})",
                           "f.json"));
  const auto absent = read_fault_script("/nowhere/faults.json");
  REQUIRE_FALSE(absent);
  CHECK(absent.error().front().file == "/nowhere/faults.json");
}

TEST_CASE("what the reader of fault files refuses does not fit the schema, what it takes does") {
  for (const std::string& text : kRefused) {
    INFO(text);
    CHECK_FALSE(parse_fault_script(text, "f.json"));
  }
  if (!testing::has_schema_validator()) {
    WARN("skipped: python3 with jsonschema is not here");
    return;
  }
  for (const auto& [kind, text] : kShortest) {
    INFO(text);
    CHECK(testing::fits_schema("faults", script_of(with(text, R"("from_s": 1, "to_s": 2)"))));
    const std::string chance = script_of(with(text, R"("chance": 0.5)"));
    CHECK(testing::fits_schema("faults", chance) == parse_fault_script(chance, "f.json").has_value());
  }
  for (const std::string& text : kRefused) {
    INFO(text);
    CHECK_FALSE(testing::fits_schema("faults", text));
  }
}

TEST_CASE(
    "the shipped fault files fit their schema, and the failing parts are of every kind that no run ends of") {
  const auto folder = testing::project_folder() / "configs" / "faults";
  const auto script = read_fault_script(folder / "failing_parts.json");
  REQUIRE(script);
  for (size_t kind = 0; kind < kFaultKinds; ++kind) {
    INFO(kFaultKindNames[kind]);
    CHECK(std::count_if(script->entries.begin(), script->entries.end(), [&](const FaultEntry& entry) {
            return entry.kind == static_cast<FaultKind>(kind);
          }) == (static_cast<FaultKind>(kind) == FaultKind::kThrow ? 0 : 1));
  }
  CHECK(read_fault_script(folder / "random.json"));
  if (!testing::has_schema_validator()) return;
  for (const char* name : {"failing_parts.json", "random.json"}) {
    std::ifstream in(folder / name);
    CHECK(testing::fits_schema("faults", {std::istreambuf_iterator<char>(in), {}}));
  }
}

}  // namespace svchain
