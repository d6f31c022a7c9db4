#include "framework/usecase/use_case.h"

#include <fstream>

#include "tests/catch.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"
#include "tests/usecase/fake_links.h"

namespace svchain {

namespace {

using testing::check_fault;
using testing::fake_catalogue;
using testing::text_of;

Faults faults_of(const std::string& text) {
  const auto use_case = parse_use_case(text, "t.json", fake_catalogue());
  REQUIRE_FALSE(use_case);
  return use_case.error();
}

const std::string kSource = R"("a": {"type": "capture", "core": "IPU1"})";
const std::string kSink = R"("b": {"type": "null", "core": "host"})";

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

}  // namespace

TEST_CASE("a use case is read with its links and edges in the file's order") {
  const auto use_case = parse_use_case(testing::kTwoDsps, "t.json", fake_catalogue());
  REQUIRE(use_case);
  CHECK(use_case->name == "2dsv_2dsp");
  CHECK(use_case->soc == "tda2x");
  REQUIRE(use_case->links.size() == 7);
  CHECK(use_case->links[0].name == "capture");
  CHECK(use_case->links[1].parameters.number("delta_ms") == 10);
  CHECK(use_case->links[6].core == "host");
  REQUIRE(use_case->edges.size() == 11);
  CHECK(use_case->edges[0].name() == "capture.front -> sync.front");
  CHECK(use_case->edges[0].depth == 2);
  CHECK(use_case->edges[9].feedback);
  CHECK(use_case->edges[10].depth == 3);
  CHECK(use_case->settings.at("view").numbers("size_px") == std::vector<double>{880, 1080});
  CHECK(use_case->settings.at("output").text("value") == "none");
  CHECK_FALSE(use_case->settings.at("rig").given("value"));
}

TEST_CASE("an edge may name its depth and its policy") {
  const auto use_case =
      parse_use_case(text_of({kSource, kSink},
                             {R"({"from": "a.front", "to": "b.in", "depth": 64, "policy": "drop_oldest"})"}),
                     "t.json", fake_catalogue());
  REQUIRE(use_case);
  CHECK(use_case->edges.front().depth == 64);
  CHECK(use_case->edges.front().policy == Policy::kDropOldest);
}

TEST_CASE("a link may drop a frame that fails") {
  const auto use_case = parse_use_case(
      text_of({R"("a": {"type": "capture", "core": "IPU1", "on_error": "drop"})"}, {}), "", fake_catalogue());
  REQUIRE(use_case);
  CHECK(use_case->links.front().on_error == OnError::kDrop);
}

TEST_CASE("a use case needs a name, links and, for each link, type and core") {
  check_fault(faults_of("{}"), "t.json:1:1: error", {"\"name\" is missing"});
  check_fault(faults_of("{}"), "t.json:1:1: error", {"\"links\" is missing"});
  check_fault(faults_of(R"({"name": "t", "links": {}})"), "t.json:1:24: error: /links",
              {"expected at least one link"});
  const auto faults = faults_of(text_of({R"("a": {})"}, {}));
  check_fault(faults, "t.json:2:6: error: /links/a", {"\"type\" is missing"});
  check_fault(faults, "t.json:2:6: error: /links/a", {"\"core\" is missing"});
}

TEST_CASE("a use case that is no object is one fault") {
  const auto faults = faults_of("[1, 2]");
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:1:1: error", {"expected an object, got an array of 2"});
}

TEST_CASE("a key that nobody knows is a fault at the top, in a link and in an edge") {
  const auto faults = faults_of(
      "{\"name\": \"t\", \"titel\": \"T\",\n\"links\": {\n"
      "\"a\": {\"type\": \"capture\", \"core\": \"IPU1\", \"parms\": {}}},\n"
      "\"edges\": [{\"from\": \"a.x\", \"to\": \"a.y\", \"dept\": 3}]}");
  CHECK(faults.size() == 3);
  check_fault(faults, "t.json:1:24: error: /titel",
              {"unknown key", "did you mean \"title\"?", "view, rig or output"});
  check_fault(faults, "t.json:3:51: error: /links/a/parms", {"unknown key", "did you mean \"params\"?"});
  check_fault(faults, "t.json:4:48: error: /edges/0/dept", {"unknown key", "did you mean \"depth\"?"});
}

TEST_CASE("a link type that nobody knows is a fault that names the nearest") {
  check_fault(faults_of(text_of({R"("a": {"type": "captur", "core": "IPU1"})"}, {})),
              "t.json:2:15: error: /links/a/type",
              {"unknown link type \"captur\"", "did you mean \"capture\"?", "capture, display, dup"});
}

TEST_CASE("a link's parameters are checked against its description") {
  const auto faults = faults_of(
      "{\"name\": \"t\", \"links\": {\"s\": {\"type\": \"sync\", \"core\": \"IPU1\",\n"
      " \"params\": {\"delta_ms\": 5000,\n  \"dleta_ms\": 1}}}}");
  CHECK(faults.size() == 2);
  check_fault(faults, "t.json:2:25: error: /links/s/params/delta_ms", {"expected 0 to 1000 ms, got 5000"});
  check_fault(faults, "t.json:3:15: error: /links/s/params/dleta_ms",
              {"unknown parameter \"dleta_ms\", did you mean \"delta_ms\"?"});
}

TEST_CASE("params that are no object are a fault even where the type is unknown") {
  const auto faults = faults_of(text_of({R"("a": {"type": "captur", "core": "IPU1", "params": 3})"}, {}));
  CHECK(faults.size() == 2);
  check_fault(faults, "", {"expected an object, got 3"});
}

TEST_CASE("a setting is checked against its description") {
  const auto faults = faults_of(
      "{\"name\": \"t\", \"view\": {\"size_px\": [880, 2],\n \"size\": 1}, \"output\": 7,\n"
      "\"links\": {\n" +
      kSource + "}}");
  CHECK(faults.size() == 3);
  check_fault(faults, "t.json:1:41: error: /view/size_px/1", {"expected 16 to 8192 px, got 2"});
  check_fault(faults, "t.json:2:10: error: /view/size",
              {"unknown parameter \"size\"", "did you mean \"size_px\"?"});
  check_fault(faults, "t.json:2:24: error: /output", {"expected a string, got 7"});
}

TEST_CASE("a link's name is lower case and no setting's") {
  const auto faults = faults_of(text_of(
      {R"("Front": {"type": "capture", "core": "IPU1"})", R"("view": {"type": "capture", "core": "IPU1"})"},
      {}));
  check_fault(faults, "t.json:2:10: error: /links/Front", {"lower case", "\"Front\""});
  check_fault(faults, "t.json:3:9: error: /links/view", {"a link cannot be named \"view\""});
}

TEST_CASE("an edge that is no edge is a fault that shows the form") {
  for (const char* edge : {"\"a.front b.in\"", "\"a.front -> b\"", "\"a -> b.in\"", "\"-> b.in\"",
                           "\"a.front -> b.in -> c.in\"", "\"\"", "\"a.front -> b.In\""}) {
    check_fault(faults_of(text_of({kSource, kSink}, {edge})), "",
                {"expected \"LINK.PORT -> LINK.PORT\", got \""});
  }
  const auto faults =
      faults_of(text_of({kSource, kSink}, {"7", R"({"from": "a", "to": 3})", R"({"from": "a.front"})"}));
  check_fault(faults, "t.json:5:1: error: /edges/0", {"expected \"LINK.PORT -> LINK.PORT\" or an object"});
  check_fault(faults, "t.json:6:10: error: /edges/1/from", {"expected \"LINK.PORT\", got \"a\""});
  check_fault(faults, "t.json:6:21: error: /edges/1/to", {"expected a string, got 3"});
  check_fault(faults, "t.json:7:1: error: /edges/2", {"\"to\" is missing"});
}

TEST_CASE("an edge to a link that is not there names the nearest") {
  const auto faults =
      faults_of(text_of({R"("capture": {"type": "capture", "core": "IPU1"})", kSink},
                        {R"("captrue.front -> b.in")", R"({"from": "capture.front", "to": "c.in"})"}));
  CHECK(faults.size() == 2);
  check_fault(faults, "t.json:5:1: error: /edges/0",
              {"there is no link \"captrue\"", "did you mean \"capture\"?", "(links: capture or b)"});
  check_fault(faults, "t.json:6:33: error: /edges/1/to", {"there is no link \"c\"", "did you mean \"b\"?"});
}

TEST_CASE("an edge's depth, policy and feedback are checked") {
  const auto faults =
      faults_of(text_of({kSource, kSink}, {R"({"from": "a.front", "to": "b.in", "depth": 65)",
                                           R"("policy": "drop_last")", R"("feedback": "yes"})"}));
  CHECK(faults.size() == 3);
  check_fault(faults, "t.json:5:44: error: /edges/0/depth", {"expected 1 to 64 frames, got 65"});
  check_fault(faults, "t.json:6:11: error: /edges/0/policy",
              {"expected block, drop_oldest, drop_newest or latest, got \"drop_last\""});
  check_fault(faults, "t.json:7:13: error: /edges/0/feedback", {"expected true or false, got \"yes\""});
}

TEST_CASE("an edge that stands twice is a fault that says where it stood first") {
  const auto faults =
      faults_of(text_of({kSource, kSink}, {R"("a.front -> b.in")", R"({"from": "a.front", "to": "b.in"})"}));
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:6:1: error: /edges/1", {"\"a.front -> b.in\" stands twice, first in line 5"});
}

TEST_CASE("a broken text is one fault with its place") {
  const auto faults = faults_of("{\"name\": \"t\",\n \"links\": }");
  CHECK(faults.size() == 1);
  check_fault(faults, "t.json:2:11: error", {"not valid JSON"});
}

TEST_CASE("a file that is not there is a fault that names it") {
  const auto use_case = read_use_case("nowhere/t.json", fake_catalogue());
  REQUIRE_FALSE(use_case);
  check_fault(use_case.error(), "nowhere/t.json: error", {"cannot be read"});
}

TEST_CASE("files are found beside the use case, or else left as they are named") {
  const testing::TemporaryFolder folder;
  write(folder.path() / "car.rig.json", "{}");
  write(folder.path() / "frames.bin", "");
  write(folder.path() / "links.so", "");
  write(folder.path() / "t.json", R"({"$schema": "use_case.json", "name": "t", "rig": "car.rig.json",
    "plugins": ["links.so", "other.so"], "links": {
    "a": {"type": "capture", "core": "IPU1", "params": {"file": "frames.bin"}},
    "b": {"type": "capture", "core": "IPU1", "params": {"file": "elsewhere.bin"}}}})");
  const auto use_case = read_use_case(folder.path() / "t.json", fake_catalogue());
  REQUIRE(use_case);
  CHECK(use_case->settings.at("rig").text("value") == (folder.path() / "car.rig.json").string());
  CHECK(use_case->links[0].parameters.text("file") == (folder.path() / "frames.bin").string());
  CHECK(use_case->links[1].parameters.text("file") == "elsewhere.bin");
  CHECK(use_case->plugins == std::vector<std::string>{(folder.path() / "links.so").string(), "other.so"});
}

TEST_CASE("plug-ins are read before the links that need them are known") {
  const testing::TemporaryFolder folder;
  write(folder.path() / "t.json",
        R"({"name": "t", "plugins": ["x.so"], "links": {"a": {"type": "new", "core": "DSP1"}}})");
  const auto plugins = read_plugins(folder.path() / "t.json");
  REQUIRE(plugins);
  CHECK(*plugins == std::vector<std::string>{"x.so"});
  write(folder.path() / "t.json", R"({"plugins": [3]})");
  const auto wrong = read_plugins(folder.path() / "t.json");
  REQUIRE_FALSE(wrong);
  check_fault(wrong.error(), "", {"expected a string, got 3"});
}

TEST_CASE("the place of a parameter is kept for faults that show later") {
  const auto use_case = parse_use_case(testing::kTwoDsps, "t.json", fake_catalogue());
  REQUIRE(use_case);
  const Fault fault = use_case->links[1].parameter_origins.at("delta_ms").fault("too long");
  CHECK(fault.text() == "t.json:3:60: error: /links/sync/params/delta_ms: too long");
}

}  // namespace svchain
