// Calls that take the time that a cost model says, on a chain small enough to know every event.

#include <nlohmann/json.hpp>

#include "tests/catch.h"
#include "tests/framework/fake_links.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

using Json = nlohmann::json;

/// Frame n comes at n ms; its call lasts 0.1 ms on A, 0.4 ms on B, 0.2 ms on A.
const std::string kDuo = R"({"name":"duo","cores":{"A":{"kind":"M4","clock_mhz":100},
  "B":{"kind":"C66x","clock_mhz":200},"C":{"kind":"C66x","clock_mhz":200}},"roles":{"host":"A"},
  "costs":{"cycles":{"M4":{"numbers":{"per_call":10000},"collect":{"per_call":20000},"fork":{}},
                     "C66x":{"add":{"per_call":80000,"source":"a data sheet"}}},
           "ipc":{"M4 -> C66x":{"latency_us":50,"note":"measured"},"C66x -> M4":{"latency_us":70}}}})";

class Modelled {
 public:
  explicit Modelled(const Json& costs = Json::object()) {
    Json soc = Json::parse(kDuo);
    soc["costs"].merge_patch(costs);
    fakes_.soc = soc.dump();
    ParameterDescription size = number("size_px", 0, {1, 1000}, "px", "of the composite");
    size.kind = Kind::kNumbers;
    size.count = 2;
    size.fallback = {100, 10};
    fakes_.catalogue.add(SettingDescription{"view", "", {size}});
  }
  Json run(const std::string& use_case, std::optional<uint64_t> seed = {}) {
    ChainOptions options = by_hand();
    options.costs = fakes_.plan(use_case).soc.costs;
    auto chain = fakes_.chain(use_case, options);
    run_by_hand(*chain, seed);
    CHECK_FALSE(chain->failure());
    const Json report = chain->report();
    for (const auto& [name, pool] : report["pools"].items()) {
      INFO(name);
      CHECK(pool["outstanding_at_stop"] == 0);
    }
    return report;
  }
  const std::vector<int64_t>& seen() const { return fakes_.seen; }
  const Fakes& fakes() const { return fakes_; }

 private:
  Fakes fakes_;
};

const Json kAddTakes2500us = {{"cycles", {{"C66x", {{"add", {{"per_call", 500'000}}}}}}}};

Json spread(double all) {
  return {{"p50", all}, {"p99", all}, {"max", all}};
}

}  // namespace

TEST_CASE("a call lasts as long as its cycles take, and what it sends is seen a latency after its end") {
  const Json report = Modelled().run(line());
  CHECK(report["links"]["numbers"]["process_ms"] == spread(0.1));
  CHECK(report["links"]["add"]["process_ms"] == spread(0.4));
  CHECK(report["links"]["collect"]["process_ms"] == spread(0.2));
  CHECK(report["edges"]["numbers.out -> add.in"]["hop_us"] == Json{{"p50", 50.0}, {"p99", 50.0}});
  CHECK(report["edges"]["add.out -> collect.in"]["hop_us"] == Json{{"p50", 70.0}, {"p99", 70.0}});
  CHECK(report["links"]["add"]["latency_ms"] == spread(0.55));      // 0.1, 0.05, 0.4
  CHECK(report["links"]["collect"]["latency_ms"] == spread(0.82));  // 0.07, 0.2
  CHECK(report["latency_ms"]["capture_to_display"] == spread(0.82));
}

TEST_CASE("loads are shares of modelled time, which ends when the last end has arrived") {
  const Json report = Modelled().run(line());
  CHECK(report["clock"] == "virtual");
  CHECK(report["wall_s"] == 0.01022);  // the source ends in a call of 0.1 ms at 10 ms
  CHECK(report["fps"] == 978.474);
  CHECK(report["cores"]["A"]["load"] == 0.3033);  // 11 calls of 0.1 ms, 10 of 0.2 ms
  CHECK(report["cores"]["B"]["load"] == 0.3914);  // 10 calls of 0.4 ms
}

TEST_CASE("what comes from 2 s after the first delivery on is told apart") {
  const std::string for_3_s = R"({"name":"line","links":{"numbers":{"type":"numbers","core":"A",
    "params":{"count":3000}},"add":{"type":"add","core":"B"},"collect":{"type":"collect","core":"A"}},
    "edges":["numbers.out -> add.in","add.out -> collect.in"]})";
  const Json after = Modelled().run(for_3_s)["after_power_up"];
  CHECK(after["first_delivery_s"] == 0.00082);
  CHECK(after["from_s"] == 2.00082);
  CHECK(after["delivered"] == 999);
  CHECK(after["dropped"] == 0);
  CHECK(after["latency_ms"]["capture_to_display"] == spread(0.82));
  CHECK(after["cores"]["B"]["load"] == 0.3998);                    // 999 calls of 0.4 ms in 999.4 ms
  CHECK_FALSE(Modelled().run(line()).contains("after_power_up"));  // over before
}

TEST_CASE("a core has one call at a time, and the link nearest to the sink goes first") {
  // All on one core: 0.1 + 4 + 0.2 ms a frame, ten times as slow as the frames come.
  const Json costs = {{"cycles", {{"M4", {{"add", {{"per_call", 400'000}}}}}}}};
  const Json report = Modelled(costs).run(R"({"name":"one","links":{"numbers":{"type":"numbers","core":"A"},
    "add":{"type":"add","core":"A"},"collect":{"type":"collect","core":"A"}},
    "edges":["numbers.out -> add.in","add.out -> collect.in"]})");
  CHECK(report["frames"]["delivered"] == 10);
  CHECK(report["wall_s"] == 0.0431);
  CHECK(report["cores"]["A"]["load"] == 1.0);
  CHECK(report["edges"]["add.out -> collect.in"]["high_water"] == 1);  // taken at once
}

TEST_CASE("where a lossless chain is too slow its queue fills, the source waits and nothing is lost") {
  Modelled modelled(kAddTakes2500us);
  const Json report = modelled.run(line());
  CHECK(modelled.seen() == std::vector<int64_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(report["edges"]["numbers.out -> add.in"]["high_water"] == 2);
  CHECK(report["edges"]["numbers.out -> add.in"]["full"] > 0);
  CHECK(report["edges"]["add.out -> collect.in"]["high_water"] == 1);
  CHECK(report["wall_s"] == 0.02542);  // 0.15, ten times 2.5, 0.07, 0.2
}

TEST_CASE("an edge that may drop drops what a slow link has not come to, at the time it is sent") {
  Modelled modelled(kAddTakes2500us);
  const Json report = modelled.run(
      line("{}", "", R"({"from":"numbers.out","to":"add.in","depth":2,"policy":"drop_oldest"})"));
  CHECK(modelled.seen() == std::vector<int64_t>{0, 1, 4, 6, 8, 9});
  CHECK(report["frames"]["dropped"] == Json{{"overwritten", 4}});
}

TEST_CASE("calls in flight share the memory's bandwidth: the slower of compute and memory counts") {
  // Tables count the view's pixels: 1000 px of 1000 bytes at 2e9 bytes/s are 0.5 ms alone, 1 ms for two.
  const Json costs = {{"cycles", {{"C66x", {{"add", {{"bytes_per_output_px", 1000}}}}}}},
                      {"memory", {{"bytes_per_s", 2e9}}}};
  const Json report = Modelled(costs).run(R"({"name":"two",
    "links":{"numbers":{"type":"numbers","core":"A"},"fork":{"type":"fork","core":"A"},
    "first":{"type":"add","core":"B"},"second":{"type":"add","core":"C"},
    "left":{"type":"collect","core":"A"},"right":{"type":"collect","core":"A"}},
    "edges":["numbers.out -> fork.in","fork.a -> first.in","fork.b -> second.in",
    "first.out -> left.in","second.out -> right.in"]})");
  CHECK(report["links"]["first"]["process_ms"] == spread(0.5));
  CHECK(report["links"]["second"]["process_ms"] == spread(1.0));
}

TEST_CASE("a result costs where something is sent, and only there") {
  const Json costs = {{"cycles", {{"C66x", {{"add", {{"per_call", 0}, {"per_result", 100'000}}}}}}}};
  const Json report = Modelled(costs).run(line(R"({"silent_at":9})"));
  CHECK(report["links"]["add"]["processed"] == 10);
  CHECK(report["links"]["add"]["process_ms"] == Json{{"p50", 0.5}, {"p99", 0.5}, {"max", 0.5}});
  CHECK(report["wall_s"] == 0.01022);
  CHECK(report["cores"]["B"]["load"] == 0.4403);  // 9 calls of 0.5 ms
}

TEST_CASE("modelled runs are the same to the byte, and a seed has an order of its own that it repeats") {
  const auto text = [](std::optional<uint64_t> seed) { return Modelled().run(loop("A"), seed).dump(); };
  CHECK(text({}) == text({}));
  for (uint64_t seed = 0; seed < 10; ++seed) CHECK(text(seed) == text(seed));
}

TEST_CASE("in every order that a seed picks a modelled chain delivers what it delivers without a model") {
  Fakes plain;
  run_by_hand(*plain.chain(loop("A"), by_hand()));
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Modelled modelled;
    modelled.run(loop("A"), seed);
    CHECK(modelled.seen() == plain.seen);
  }
}

TEST_CASE("a modelled chain gets over a lost token and a link that throws") {
  for (const std::string params : {R"({"plus":500,"silent_at":4})", R"({"plus":500,"throw_at":4})"}) {
    Modelled modelled;
    modelled.run(loop("A", params, R"(,"on_error":"drop")"));
    REQUIRE(modelled.seen().size() == 10);
    CHECK(modelled.seen()[5] == 5503);
  }
}

TEST_CASE("the report says what a modelled run rests on: sources, assumptions and defaults") {
  const Json no_figure = {{"cycles", {{"M4", {{"numbers", nullptr}}}}}};
  const Json rests = Modelled(no_figure).run(line())["modelled"];
  CHECK(rests["links"]["add"] == Json{{"basis", "a data sheet"},
                                      {"per_call", 80000.0},
                                      {"core_kind", "C66x"},
                                      {"clock_mhz", 200.0},
                                      {"clock_basis", "assumed"}});
  CHECK(rests["links"]["collect"]["basis"] == "assumed");
  CHECK(rests["links"]["numbers"]["basis"] == CostModel::kCallWithoutFigure.basis);
  CHECK(rests["ipc"]["M4 -> C66x"] == Json{{"latency_us", 50.0}, {"basis", "measured"}});
  CHECK(rests["ipc"]["C66x -> M4"]["basis"] == "assumed");
}

TEST_CASE("a core without a clock cannot be modelled, and is named") {
  Fakes fakes;
  ChainOptions options = by_hand();
  options.costs.emplace();
  Chain chain(fakes.plan(line()), options);
  const auto configured = chain.configure();
  REQUIRE_FALSE(configured);
  REQUIRE(configured.error().size() == 2);
  CHECK(configured.error()[0].text() ==
        "duo: error: /cores/A: \"clock_mhz\" is missing: without it no call there can be modelled");
}
