// The commands beside running: list, validate, graph, schema.

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE(
    "list tells the links with their ports and parameters, the use cases, the SoCs, the lenses and faults") {
  const auto links = svchain_program({"list", "links"});
  CHECK(links.status == 0);
  CHECK_THAT(links.out, Contains("synthesis") && Contains("delta_ms") && Contains("in  frames") &&
                            Contains("view.size_px"));
  CHECK_THAT(svchain_program({"list", "usecases"}).out, Contains("2dsv_2dsp"));
  CHECK_THAT(svchain_program({"list", "socs"}).out, Contains("tda3x") && Contains("EVE1"));
  CHECK_THAT(svchain_program({"list", "lenses"}).out,
             Contains("kannala_brandt") && Contains("double_sphere"));
  CHECK_THAT(svchain_program({"list", "faults"}).out,
             Contains("failing_parts") && Contains("12 faults") && Contains("120 an hour at random"));
  CHECK_THAT(svchain_program({"list"}).out, Contains("2dsv_2dsp") && Contains("kannala_brandt"));
  CHECK(svchain_program({"list", "rigs"}).status == 2);
}

TEST_CASE("validate tells what a sound file is") {
  const auto project = project_folder();
  const auto outcome =
      svchain_program({"validate", project / "usecases/2dsv_2dsp.json", project / "configs/rigs/car.json",
                       project / "configs/socs/tda2x.json", project / "configs/scenes/parking.json",
                       project / "configs/charts/garage.json", project / "configs/faults/random.json"});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("2dsv_2dsp.json: ok (use case)") && Contains("car.json: ok (rig)"));
  CHECK_THAT(outcome.out, Contains("tda2x.json: ok (SoC)") && Contains("parking.json: ok (scene)") &&
                              Contains("garage.json: ok (charts)") && Contains("random.json: ok (faults)"));
}

TEST_CASE("validate tells every fault of every file and still what is sound") {
  const TemporaryFolder folder;
  Json rig = small_rig();
  rig["cameras"].erase("left");
  rig["vehicle"]["length_m"] = -1;
  write_json(folder.path() / "rig.json", rig);
  write_text(folder.path() / "odd.json", R"({"what": "ever"})");
  const auto outcome = svchain_program({"validate", folder.path() / "rig.json", folder.path() / "odd.json",
                                        project_folder() / "configs/socs/tda2x.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("length_m") && Contains("left") && Contains("odd.json: error: what is it?"));
  CHECK_THAT(outcome.out, Contains("tda2x.json: ok (SoC)"));
}

TEST_CASE("every shipped charts file, rig and fault file is sound") {
  for (const char* kind : {"charts", "rigs", "faults"}) {
    Arguments arguments = {"validate"};
    for (const auto& file : std::filesystem::directory_iterator(project_folder() / "configs" / kind)) {
      arguments.push_back(file.path());
    }
    REQUIRE(arguments.size() > 2);
    const auto outcome = svchain_program(arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
  }
}

TEST_CASE("a graph is drawn as dot, as SVG and as JSON, with the IPC pairs") {
  const auto dot = svchain_program({"graph", "2dsv_2dsp"});
  CHECK(dot.status == 0);
  CHECK_THAT(dot.out, StartsWith("digraph"));
  CHECK_THAT(svchain_program({"graph", "2dsv_2dsp", "--format", "svg"}).out, Contains("<svg"));
  const auto json = svchain_program({"graph", "2dsv_2dsp", "--format", "json"});
  REQUIRE(json.status == 0);
  CHECK_THAT(Json::parse(json.out).dump(), Contains("ipc_out"));
  CHECK(svchain_program({"graph", "2dsv_2dsp", "--format", "png"}).status == 2);
}

TEST_CASE("schemas are printed for every file format") {
  for (const char* kind : {"usecase", "rig", "charts", "corners", "calibration", "soc", "costs", "scene",
                           "path", "faults", "report"}) {
    INFO(kind);
    const auto outcome = svchain_program({"schema", kind});
    CHECK(outcome.status == 0);
    CHECK(Json::accept(outcome.out));
  }
  const auto unknown = svchain_program({"schema", "rigs"});
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("did you mean \"rig\"?"));
}
