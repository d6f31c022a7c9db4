#include "framework/usecase/soc.h"

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

TEST_CASE("a SoC needs a name and cores") {
  check_fault(faults_of("{}"), "", {"\"name\" is missing"});
  check_fault(faults_of("{}"), "", {"\"cores\" is missing"});
  check_fault(faults_of(R"({"name": "s", "cores": {}})"), "", {"expected at least one core"});
  CHECK(faults_of("3").size() == 1);
}

}  // namespace svchain
