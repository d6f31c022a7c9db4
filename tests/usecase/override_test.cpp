#include "framework/usecase/use_case.h"
#include "tests/catch.h"
#include "tests/usecase/expect.h"
#include "tests/usecase/fake_links.h"

namespace svchain {

namespace {

using testing::check_fault;

Result<UseCase> with(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const auto& text : texts) overrides.push_back({text});
  return parse_use_case(testing::kTwoDsps, "t.json", testing::fake_catalogue(), overrides);
}

Faults faults_with(const std::vector<std::string>& texts) {
  const auto use_case = with(texts);
  REQUIRE_FALSE(use_case);
  return use_case.error();
}

}  // namespace

TEST_CASE("an override by --set changes parameters of links and settings") {
  const auto use_case = with({"synthesis.kernel=portable", "view.size_px=[440,540]",
                              "view.metres_per_px=0.01", "output=a=b.png", "sync.delta_ms=20"});
  REQUIRE(use_case);
  CHECK(use_case->links[4].parameters.text("kernel") == "portable");
  CHECK(use_case->settings.at("view").numbers("size_px") == std::vector<double>{440, 540});
  CHECK(use_case->settings.at("view").number("metres_per_px") == 0.01);
  CHECK(use_case->settings.at("output").text("value") == "a=b.png");
  CHECK(use_case->links[1].parameters.number("delta_ms") == 20);
}

TEST_CASE("a later fault of a parameter that --set gave points at the option") {
  const auto use_case = with({"sync.delta_ms=20"});
  REQUIRE(use_case);
  CHECK(use_case->links[1].parameter_origins.at("delta_ms").fault("no").text() ==
        "--set sync.delta_ms=20: error: no");
}

TEST_CASE("every wrong --set is reported at once, by its own text") {
  const auto faults =
      faults_with({"synthesys.kernel=portable", "synthesis.kernal=portable", "synthesis.kernel=portabel",
                   "sync.delta_ms=5000", "view.size=1", "veiw.size_px=[1,2]"});
  CHECK(faults.size() == 6);
  check_fault(faults, "--set synthesys.kernel=portable: error",
              {"there is no link or setting \"synthesys\"", "did you mean \"synthesis\"?"});
  check_fault(faults, "--set synthesis.kernal=portable: error",
              {"unknown parameter \"kernal\", did you mean \"kernel\"?"});
  check_fault(faults, "--set synthesis.kernel=portabel: error", {"did you mean \"portable\"?"});
  check_fault(faults, "--set sync.delta_ms=5000: error", {"expected 0 to 1000 ms, got 5000"});
  check_fault(faults, "--set view.size=1: error", {"unknown parameter \"size\", did you mean \"size_px\"?"});
  check_fault(faults, "--set veiw.size_px=[1,2]: error", {"did you mean \"view\"?"});
}

TEST_CASE("an override by --set needs a target that has values") {
  const auto faults = faults_with({"edges=[]", "synthesis=3", "view=3", "rig.value=x", "nonsense"});
  CHECK(faults.size() == 5);
  check_fault(faults, "--set edges=[]: error",
              {"there is no link or setting \"edges\"", "expected LINK.PARAMETER=VALUE"});
  check_fault(faults, "--set synthesis=3: error", {"which parameter of \"synthesis\"?"});
  check_fault(faults, "--set view=3: error", {"\"view\" has parts, expected view.KEY=VALUE"});
  check_fault(faults, "--set rig.value=x: error", {"\"rig\" has no parts, expected rig=VALUE"});
  check_fault(faults, "--set nonsense: error", {"expected LINK.PARAMETER=VALUE", "got \"nonsense\""});
}

TEST_CASE("an override by --set says how many CPUs a core has") {
  const auto use_case = parse_use_case(R"({"name": "t", "cpus": {"DSP1": 3}, "links":
    {"a": {"type": "capture", "core": "IPU1"}}})",
                                       "t.json", testing::fake_catalogue(), {{"cpus.DSP1=2"}});
  REQUIRE(use_case);
  REQUIRE(use_case->cpus.size() == 2);
  CHECK(use_case->cpus[0].cpus == 3);
  CHECK(use_case->cpus[1].core == "DSP1");
  CHECK(use_case->cpus[1].cpus == 2);
  const auto faults = faults_with({"cpus.DSP1=0", "cpus.DSP1=two", "cpus.DSP1=65"});
  CHECK(faults.size() == 3);
  check_fault(faults, "--set cpus.DSP1=0: error", {"expected a whole number from 1 to 64, got \"0\""});
  check_fault(faults, "--set cpus.DSP1=two: error", {"got \"two\""});
}

TEST_CASE("an override by --set says what an error in a link does") {
  const auto use_case = with({"synthesis.on_error=drop", "sync.on_error=drop", "sync.on_error=stop"});
  REQUIRE(use_case);
  CHECK(use_case->links[4].on_error == OnError::kDrop);
  CHECK(use_case->links[1].on_error == OnError::kStop);
  CHECK(use_case->links[0].on_error == OnError::kStop);
  const auto faults = faults_with({"synthesis.on_error=dorp", "synthesis.on_eror=drop"});
  CHECK(faults.size() == 2);
  check_fault(faults, "--set synthesis.on_error=dorp: error", {"expected stop or drop", "got \"dorp\""});
  check_fault(faults, "--set synthesis.on_eror=drop: error", {"unknown parameter \"on_eror\""});
}

TEST_CASE("faults of the file and of --set come together") {
  const auto use_case = parse_use_case(R"({"name": "t", "links": {"a": {"type": "captur", "core": "IPU1"}}})",
                                       "t.json", testing::fake_catalogue(), {{"a.x=1"}, {"b.x=1"}});
  REQUIRE_FALSE(use_case);
  CHECK(use_case.error().size() == 2);
}

}  // namespace svchain
