#include "framework/usecase/soc.h"

#include <fstream>

#include "tests/catch.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"

namespace svchain {

namespace {

using testing::check_fault;

Soc shipped(const std::string& name) {
  const auto soc = read_soc(testing::project_folder() / "configs" / "socs" / (name + ".json"));
  if (!soc) FAIL(soc.error().front().text());
  return *soc;
}

Faults faults_of(const std::string& text) {
  const auto soc = parse_soc(text, "s.json");
  REQUIRE_FALSE(soc);
  return soc.error();
}

}  // namespace

TEST_CASE("the shipped SoCs have their cores in the order of the file") {
  CHECK(shipped("tda2x").core_names() == std::vector<std::string>{"A15", "IPU1", "IPU2", "DSP1", "DSP2",
                                                                  "EVE1", "EVE2", "EVE3", "EVE4", "SGX"});
  CHECK(shipped("tda2eco").core_names() == std::vector<std::string>{"A15", "IPU1", "IPU2", "DSP1", "SGX"});
  CHECK(shipped("tda3x").core_names() == std::vector<std::string>{"IPU1", "DSP1", "DSP2", "EVE1"});
}

TEST_CASE("the host of a SoC without A15 is its IPU") {
  CHECK(shipped("tda2x").find("host")->name == "A15");
  CHECK(shipped("tda2x").find("host")->count == 2);
  CHECK(shipped("tda3x").find("host")->name == "IPU1");
  CHECK(shipped("tda3x").find("A15") == nullptr);
  CHECK(shipped("tda2x").find("DSP1")->clock_mhz == 600);
}

TEST_CASE("every fault of a SoC file is reported") {
  const auto faults = faults_of(
      "{\"name\": \"s\", \"core\": {},\n\"cores\": {\"DSP1\": {\"kind\": 3, \"clock_mhz\": -1},\n"
      "\"DSP2\": {\"count\": 0, \"speed\": 1}},\n\"roles\": {\"host\": \"DPS1\", \"DSP2\": \"DSP1\"}}");
  CHECK(faults.size() == 8);
  check_fault(faults, "s.json:1:23: error: /core", {"unknown key", "did you mean \"cores\"?"});
  check_fault(faults, "s.json:2:28: error: /cores/DSP1/kind", {"expected a string, got 3"});
  check_fault(faults, "s.json:2:44: error: /cores/DSP1/clock_mhz", {"expected 1 to 10000 MHz, got -1"});
  check_fault(faults, "s.json:3:9: error: /cores/DSP2", {"\"kind\" is missing"});
  check_fault(faults, "s.json:3:19: error: /cores/DSP2/count", {"expected 1 to 64, got 0"});
  check_fault(faults, "s.json:3:31: error: /cores/DSP2/speed", {"unknown key"});
  check_fault(faults, "s.json:4:19: error: /roles/host",
              {"there is no core \"DPS1\"", "did you mean \"DSP1\"?"});
  check_fault(faults, "s.json:4:35: error: /roles/DSP2", {"a role cannot be named \"DSP2\""});
}

TEST_CASE("the shipped SoCs say what synthesis, photometric alignment and IPC cost, and where that is from") {
  for (const std::string name : {"tda2x", "tda2eco", "tda3x"}) {
    const CostModel costs = shipped(name).costs;
    const CallCost& synthesis = costs.call("C66x", "synthesis");
    CHECK(synthesis.per_output_px * 880 * 1080 * 30 == Approx(0.75 * 600e6).epsilon(1e-4));
    CHECK(synthesis.basis.starts_with("the paper"));
    const CallCost& photometric = costs.call("C66x", "photometric_alignment");
    CHECK(photometric.per_output_px * 880 * 1080 * 30 == Approx(0.03 * 600e6).epsilon(1e-4));
    CHECK(costs.call("C66x", "geometric_alignment").per_result == 5 * 600e6);
    CHECK(costs.hop("M4", "C66x").latency_us == 77);
    CHECK(costs.hop("C66x", "C66x").basis == "SDK data sheet");
    CHECK(costs.memory.basis == "assumed");
  }
}

TEST_CASE("what a SoC file has no figure for costs a default that says so") {
  const CostModel costs = shipped("tda2x").costs;
  CHECK_FALSE(costs.has_call("EVE", "synthesis"));
  CHECK(&costs.call("EVE", "synthesis") == &CostModel::kCallWithoutFigure);
  CHECK(&costs.hop("EVE", "SGX") == &CostModel::kIpcWithoutFigure);
}

TEST_CASE("a clock is published somewhere, noted as something, or assumed") {
  CHECK(shipped("tda2x").find("DSP2")->clock_basis.starts_with("the paper"));
  CHECK(shipped("tda2x").find("EVE1")->clock_basis == "clock assumed");
  const auto plain = parse_soc(R"({"name":"s","cores":{"A":{"kind":"M4","clock_mhz":200}}})", "s.json");
  REQUIRE(plain);
  CHECK(plain->find("A")->clock_basis == "assumed");
}

TEST_CASE("figures of a costs file win over those of the SoC, and all others stay") {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "costs.json";
  const auto write = [&](const std::string& text) { std::ofstream(file) << text; };
  write(
      R"({"costs":{"cycles":{"C66x":{"dup":{"per_call":7,"source":"measured"}},"EVE":{"edge":{"per_call":1}}}}})");
  const auto measured = read_cost_file(file);
  REQUIRE(measured);
  Soc soc = shipped("tda2x");
  overlay(soc.costs, *measured);
  CHECK(soc.costs.call("C66x", "dup").per_call == 7);
  CHECK(soc.costs.call("C66x", "dup").basis == "measured");
  CHECK(soc.costs.call("M4", "dup").per_call == 2000);
  CHECK(soc.costs.call("EVE", "edge").basis == "assumed");
  CHECK(soc.costs.hop("M4", "C66x").latency_us == 77);
  CHECK(soc.costs.memory.bytes_per_s == 8.5e9);

  write(R"({"costs":{"cycles":{"C66x":{"dup":{"per_cal":7}}}},"cores":{}})");
  const auto bad = read_cost_file(file);
  REQUIRE_FALSE(bad);
  CHECK(bad.error().size() == 2);
  check_fault(bad.error(), "", {"unknown key, did you mean \"per_call\"?"});
  check_fault(bad.error(), "", {"unknown key (known: costs)"});
}

TEST_CASE("every fault among the costs is reported") {
  const auto faults = faults_of(
      R"({"name":"s","cores":{"A":{"kind":"M4"}},"costs":{"cycle":{},
"cycles":{"M4":{"dup":{"per_cal":1,"per_call":-1}}},
"ipc":{"M4 to C66x":{"latency_us":1},"M4 -> EVE":{}},
"memory":{"bytes_per_s":0}}})");
  CHECK(faults.size() == 6);
  check_fault(faults, "s.json:1:58: error: /costs/cycle", {"unknown key", "did you mean \"cycles\"?"});
  check_fault(faults, "s.json:2:34: error: /costs/cycles/M4/dup/per_cal", {"did you mean \"per_call\"?"});
  check_fault(faults, "s.json:2:47: error: /costs/cycles/M4/dup/per_call", {"0 to 1e+15 cycles, got -1"});
  check_fault(faults, "", {"expected two kinds of cores, as in \"M4 -> C66x\", got \"M4 to C66x\""});
  check_fault(faults, "", {"\"latency_us\" is missing"});
  check_fault(faults, "", {"bytes/s, got 0"});
}

TEST_CASE("a SoC needs a name and cores") {
  check_fault(faults_of("{}"), "", {"\"name\" is missing"});
  check_fault(faults_of("{}"), "", {"\"cores\" is missing"});
  check_fault(faults_of(R"({"name": "s", "cores": {}})"), "", {"expected at least one core"});
  CHECK(faults_of("3").size() == 1);
}

}  // namespace svchain
