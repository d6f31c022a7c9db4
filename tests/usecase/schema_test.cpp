#include "framework/usecase/schema.h"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/catch.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"
#include "tests/usecase/fake_links.h"

namespace svchain {

namespace {

const char* const kValidator = R"(
import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
sys.exit(0 if jsonschema.Draft202012Validator(schema).is_valid(json.load(open(sys.argv[2]))) else 3)
)";

bool has_validator() {
  return std::system("python3 -c 'import jsonschema' 2>/dev/null") == 0;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// 0: valid, 3: not valid, else the schema itself is broken.
int validate(const std::string& schema, const std::string& text) {
  const testing::TemporaryFolder folder;
  write(folder.path() / "validate.py", kValidator);
  write(folder.path() / "schema.json", schema);
  write(folder.path() / "text.json", text);
  const std::string base = folder.path().string();
  const int status = std::system(
      ("python3 " + base + "/validate.py " + base + "/schema.json " + base + "/text.json").c_str());
  return WEXITSTATUS(status);
}

std::string file(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("the schema of use cases has every link type with its ranges, choices and units") {
  const auto schema = nlohmann::json::parse(use_case_schema(testing::fake_catalogue()));
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(schema["properties"]["view"]["properties"]["size_px"]["maxItems"] == 2);
  for (const auto& rule : schema["$defs"]["link"]["allOf"]) {
    const auto& params = rule["then"]["properties"]["params"]["properties"];
    if (rule["if"]["properties"]["type"]["const"] == "sync") {
      CHECK(params["delta_ms"]["maximum"] == 1000);
      CHECK(params["delta_ms"]["description"] == "how far apart, in ms");
    }
    if (rule["if"]["properties"]["type"]["const"] == "synthesis") CHECK(params["kernel"]["enum"].size() == 3);
  }
  CHECK(schema["$defs"]["link"]["allOf"].size() == testing::fake_catalogue().link_types().size());
}

TEST_CASE("a validator takes what the reader takes and refuses what it refuses") {
  if (!has_validator()) {
    WARN("skipped: python3 with jsonschema is not here");
    return;
  }
  const auto catalogue = testing::fake_catalogue();
  const std::string schema = use_case_schema(catalogue);
  const std::string good = testing::kTwoDsps;
  REQUIRE(validate(schema, good) == 0);
  const std::vector<std::pair<std::string, std::string>> slips = {
      {"\"delta_ms\":10", "\"delta_ms\":5000"},
      {"\"delta_ms\":10", "\"dleta_ms\":10"},
      {"\"type\":\"dup\"", "\"type\":\"dupe\""},
      {"sync.frames -> dup.in", "sync.frames dup.in"},
      {"\"depth\":3", "\"depth\":65"},
      {"\"policy\":\"block\"", "\"policy\":\"wait\""},
      {"\"feedback\":true", "\"feedback\":1"},
      {"\"size_px\":[880,1080]", "\"size_px\":[880]"},
      {"\"name\":\"2dsv_2dsp\",", ""},
      {"\"dup\":{", "\"Dup\":{"},
      {"\"name\":\"2dsv_2dsp\",", "\"name\":\"2dsv_2dsp\",\"nmae\":1,"}};
  for (const auto& [from, to] : slips) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    INFO(to);
    CHECK(validate(schema, bad) == 3);
    CHECK_FALSE(parse_use_case(bad, "t.json", catalogue));
  }
}

TEST_CASE("the shipped SoCs fit their schema") {
  if (!has_validator()) {
    WARN("skipped: python3 with jsonschema is not here");
    return;
  }
  const auto configs = testing::project_folder() / "configs";
  const std::string schema = file(configs / "schemas" / "soc.schema.json");
  for (const char* name : {"tda2x.json", "tda2eco.json", "tda3x.json"}) {
    CHECK(validate(schema, file(configs / "socs" / name)) == 0);
  }
  CHECK(validate(schema, R"({"name": "s", "cores": {}})") == 3);
  CHECK(validate(schema, R"({"name": "s", "cores": {"DSP1": {"kind": "C66x", "speed": 1}}})") == 3);
}

TEST_CASE("the schema of reports takes a full report and refuses a wrong one") {
  if (!has_validator()) {
    WARN("skipped: python3 with jsonschema is not here");
    return;
  }
  const std::string schema = file(testing::project_folder() / "configs" / "schemas" / "report.schema.json");
  const std::string good =
      R"({"usecase":"t","soc":"tda2x","frames":{"captured":3,"delivered":2,"dropped":{"late":1}},
    "wall_s":1.0,"fps":100.0,"view":{"size_px":[880,1080],"metres_per_px":0.0085,"centre_m":[0,0]},
    "latency_ms":{"capture_to_display":{"p50":0,"p99":0,"max":0}},"cores":{"DSP1":{"load":0.5}},
    "links":{"a":{"core":"DSP1","processed":3,"process_ms":{"p50":0,"p99":0,"max":0},"dropped":{}}},
    "edges":{"a.x -> b.y":{"ipc":true,"messages":3,"hop_us":{"p50":0,"p99":0},"full":0}},
    "pools":{"a":{"buffers":3,"high_water":2,"outstanding_at_stop":0}},"output":{"sha256":")" +
      std::string(64, 'a') + "\"}}";
  CHECK(validate(schema, good) == 0);
  CHECK(validate(schema, R"({"usecase":"t"})") == 3);
  std::string negative = good;
  negative.replace(negative.find("\"delivered\":2"), 13, "\"delivered\":-2");
  CHECK(validate(schema, negative) == 3);
}

}  // namespace svchain
