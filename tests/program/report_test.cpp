// The report that other people's scripts read.

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

struct Stills {
  TemporaryFolder folder;
  Stills() {
    write_json(folder.path() / "rig.json", small_rig());
    write_stills(folder.path() / "input");
  }
  Outcome run(const Arguments& more) const {
    return svchain_program(small_run("2dsv_2dsp", folder.path() / "rig.json", folder.path() / "input", more));
  }
};

}  // namespace

TEST_CASE("the report goes to stdout alone, with every part of the contract") {
  const Stills stills;
  const auto outcome = stills.run({"--frames", "4", "--report", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json report = Json::parse(outcome.out);
  for (const char* key : {"usecase", "soc", "view", "frames", "wall_s", "fps", "latency_ms", "cores", "links",
                          "edges", "pools", "photometric", "output"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  CHECK(report["usecase"] == "2dsv_2dsp");
  CHECK(report["view"]["size_px"] == Json({220, 270}));
  CHECK(report["frames"]["captured"] == 4);
  CHECK(report["frames"]["delivered"] == 4);
  CHECK(report["links"]["synthesis"]["core"] == "DSP2");
  CHECK(report["edges"]["dup.out1 -> synthesis.frames"]["ipc"] == true);
  CHECK(report["photometric"]["tone_mapping"]["front"]["b"].size() == 256);
}

TEST_CASE("stills are shown thirty times, and without a report nothing is on stdout") {
  const Stills stills;
  const auto outcome = stills.run({});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Contains("30 frames captured, 30 delivered, none dropped"));
}

TEST_CASE("a report replaces an older one of the same name, and what a link points to") {
  const Stills stills;
  const auto real = stills.folder.path() / "real.json";
  write_text(real, "old");
  std::filesystem::create_symlink(real, stills.folder.path() / "report.json");
  CHECK(stills.run({"--frames", "2", "--report", stills.folder.path() / "report.json"}).status == 0);
  CHECK(std::filesystem::is_symlink(stills.folder.path() / "report.json"));
  CHECK(Json::parse(read_text(real))["frames"]["delivered"] == 2);
}

TEST_CASE("a real-time run accounts for every frame: captured is delivered and dropped") {
  const Stills stills;
  const auto outcome = stills.run({"--frames", "20", "--fps", "1000", "--report", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json frames = Json::parse(outcome.out)["frames"];
  int dropped = 0;
  for (const auto& [reason, count] : frames["dropped"].items()) dropped += count.get<int>();
  CHECK(frames["captured"] == 20);
  CHECK(frames["delivered"].get<int>() + dropped == 20);
}

TEST_CASE("a fresh machine needs no data: the built-in scene is the input") {
  const auto outcome =
      svchain_program({"--usecase", "2dsv_1dsp", "--frames", "2", "--set", "view.size_px=[220,270]"});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Contains("2 frames captured, 2 delivered, none dropped"));
}
