// What faults do to a chain small enough to know every frame: 0, 1, 2, ... a millisecond apart, from A over
// B.

#include <algorithm>
#include <future>
#include <nlohmann/json.hpp>
#include <numeric>

#include "framework/fault/fault_site.h"
#include "framework/fault/recovery.h"
#include "tests/catch.h"
#include "tests/framework/fake_links.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

using Json = nlohmann::json;

constexpr int64_t kMs = 1'000'000;

class FaultyLine {
 public:
  explicit FaultyLine(std::string use_case = line()) : use_case_(std::move(use_case)) {}

  FaultyLine& with(const std::string& entry) {
    entries_ += (entries_.empty() ? "" : ",") + entry;
    return *this;
  }
  Json run_by_hand(std::optional<uint64_t> order = {}) {
    fakes_.seen.clear();
    auto chain = fakes_.chain(use_case_, with_faults(by_hand()));
    svchain::run_by_hand(*chain, order);
    return report_of(*chain);
  }
  Json run_on_threads() {
    fakes_.seen.clear();
    std::promise<void> finished;
    ChainOptions options = with_faults({});
    options.on_finished = [&] { finished.set_value(); };
    auto chain = fakes_.chain(use_case_, options);
    chain->start();
    finished.get_future().wait();
    chain->stop();
    return report_of(*chain);
  }
  const std::vector<int64_t>& seen() const { return fakes_.seen; }

  uint64_t seed = 1;

 private:
  ChainOptions with_faults(ChainOptions options) const {
    const auto script = parse_fault_script("{\"faults\":[" + entries_ + "]}", "faults.json");
    if (!script) throw std::runtime_error(script.error().front().text());
    auto placed = place_faults(*script, fakes_.plan(use_case_), seed);
    if (!placed) throw std::runtime_error(placed.error().front().text());
    options.faults = std::move(*placed);
    return options;
  }
  static Json report_of(const Chain& chain) {
    Json report = chain.report();
    if (chain.failure()) report["failure"] = chain.failure()->text();
    CHECK(chain.outstanding().empty());
    return report;
  }

  Fakes fakes_;
  std::string use_case_, entries_;
};

std::vector<int64_t> numbers_to(int64_t end) {
  std::vector<int64_t> all(static_cast<size_t>(end));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

PlannedFault planned(double from_s, double to_s) {
  PlannedFault fault;
  fault.from_ns = static_cast<int64_t>(from_s * 1e9);
  fault.to_ns = static_cast<int64_t>(to_s * 1e9);
  return fault;
}

}  // namespace

TEST_CASE("a lost message is counted on its edge, and nothing else is missing") {
  FaultyLine line;
  const Json report =
      line.with(R"({"kind":"lost","at":"add.out -> collect.in","from_s":0.0035,"to_s":0.0065})")
          .run_by_hand();
  CHECK(line.seen() == std::vector<int64_t>{0, 1, 2, 3, 7, 8, 9});
  CHECK(report["edges"]["add.out -> collect.in"]["dropped"] == Json{{"lost", 3}});
  CHECK(report["frames"] == Json{{"captured", 10}, {"delivered", 7}, {"dropped", {{"lost", 3}}}});
  CHECK(report["faults"]["list"][0]["times"] == 3);
}

TEST_CASE(
    "what chance loses is the same by hand in any order and on threads, and another seed's is another") {
  const std::string entry = R"({"kind":"lost","at":"numbers.out","chance":0.4})";
  FaultyLine line(svchain::testing::line("{}"));
  line.with(entry).run_by_hand();
  const std::vector<int64_t> expected = line.seen();
  CHECK(expected.size() > 0);
  CHECK(expected.size() < 10);
  for (uint64_t order = 1; order < 5; ++order) {
    line.run_by_hand(order);
    CHECK(line.seen() == expected);
  }
  line.run_on_threads();
  CHECK(line.seen() == expected);
  line.seed = 2;
  line.run_by_hand();
  CHECK(line.seen() != expected);
}

TEST_CASE("late messages keep their order, and so do those behind them and the end") {
  FaultyLine line;
  const Json report =
      line.with(R"({"kind":"late","at":"add.out","from_s":0.0025,"to_s":0.0045,"late_ms":30})").run_by_hand();
  CHECK(line.seen() == numbers_to(10));
  CHECK(report["frames"]["delivered"] == 10);
  CHECK(report["wall_s"].get<double>() >= 0.033);
}

TEST_CASE("a core that stands still goes on where it was") {
  FaultyLine line;
  const Json report = line.with(R"({"kind":"halt","at":"B","from_s":0.0025,"to_s":0.05})").run_by_hand();
  CHECK(line.seen() == numbers_to(10));
  CHECK(report["wall_s"].get<double>() >= 0.05);
  CHECK(report["faults"]["list"][0]["times"] == 1);
}

TEST_CASE("a full edge and a link without memory hold up what comes, and lose nothing in a lossless run") {
  for (const std::string fault : {R"({"kind":"full","at":"add.out","from_s":0.0025,"to_s":0.05})",
                                  R"({"kind":"no_memory","at":"add","from_s":0.0025,"to_s":0.05})"}) {
    FaultyLine line;
    const Json report = line.with(fault).run_by_hand();
    INFO(fault);
    CHECK(line.seen() == numbers_to(10));
    CHECK(report["wall_s"].get<double>() >= 0.05);
  }
}

TEST_CASE("a source, a link and a sink that throw lose their frames, each counted once") {
  for (const std::string name : {"numbers", "add", "collect"}) {
    FaultyLine line(R"({"name":"line","links":{
      "numbers":{"type":"numbers","core":"A","on_error":"drop"},"add":{"type":"add","core":"B","on_error":"drop"},
      "collect":{"type":"collect","core":"A","on_error":"drop"}},
      "edges":["numbers.out -> add.in","add.out -> collect.in"]})");
    const Json report =
        line.with(R"({"kind":"throw","at":")" + name + R"(","from_s":0.0025,"to_s":0.0055})").run_by_hand();
    INFO(name);
    CHECK(line.seen() == std::vector<int64_t>{0, 1, 2, 6, 7, 8, 9});
    CHECK(report["links"][name]["dropped"] == Json{{"error", 3}});
    CHECK(report["frames"] == Json{{"captured", 10}, {"delivered", 7}, {"dropped", {{"error", 3}}}});
  }
}

TEST_CASE("a link that throws and whose policy is to stop ends the run, which says that it was a fault") {
  FaultyLine line;
  const Json report = line.with(R"({"kind":"throw","at":"add","from_s":0.0025})").run_by_hand();
  CHECK(report["failure"] == "B/add: frame 3: a fault of the fault file");
  CHECK(line.seen() == numbers_to(3));
}

TEST_CASE("a set that gets lost on both ways to a join is counted once") {
  FaultyLine line(R"({"name":"join","links":{"numbers":{"type":"numbers","core":"A"},
    "fork":{"type":"fork","core":"A"},"add":{"type":"add","core":"B"},"join":{"type":"join","core":"A"},
    "collect":{"type":"collect","core":"A"}},
    "edges":["numbers.out -> fork.in","fork.a -> add.in","add.out -> join.a","fork.b -> join.b","join.out -> collect.in"]})");
  const Json report = line.with(R"({"kind":"lost","at":"add.out","from_s":0.0025,"to_s":0.0055})")
                          .with(R"({"kind":"lost","at":"fork.b","from_s":0.0035,"to_s":0.0065})")
                          .run_by_hand();
  CHECK(line.seen() == std::vector<int64_t>{0, 1001, 2002, 7007, 8008, 9009});
  CHECK(report["frames"] == Json{{"captured", 10}, {"delivered", 6}, {"dropped", {{"lost", 4}}}});
}

TEST_CASE("a lost answer on a feedback edge is a call without it, and the loop goes on") {
  FaultyLine line(loop("B"));
  const Json report =
      line.with(R"({"kind":"lost","at":"add.out","from_s":0.0025,"to_s":0.0045})").run_by_hand();
  CHECK_FALSE(report.contains("failure"));
  CHECK(line.seen().size() == 10);
  CHECK(report["frames"]["delivered"] == 10);
}

TEST_CASE("how often chance strikes is what the file says, and depends on seed and occasion alone") {
  PlannedFault lost = planned(0, 1);
  lost.kind = FaultKind::kLost;
  lost.chance = 0.25;
  InjectedFault injected{&lost, 77, {}};
  FaultSite site;
  site.reserve(1);
  CHECK_FALSE(site.strike(FaultKind::kLost, 0));
  site.begin(injected);
  std::vector<uint64_t> struck;
  for (uint64_t occasion = 0; occasion < 10'000; ++occasion)
    if (site.strike(FaultKind::kLost, occasion)) struck.push_back(occasion);
  CHECK(std::abs(static_cast<int>(struck.size()) - 2500) < 180);  // four standard deviations
  CHECK(injected.times.value() == struck.size());
  for (const uint64_t occasion : struck) CHECK(site.strike(FaultKind::kLost, occasion));
  CHECK_FALSE(site.strike(FaultKind::kLate, struck.front()));
  site.end(injected);
  CHECK_FALSE(site.strike(FaultKind::kLost, struck.front()));
}

TEST_CASE("recovery is how long after faults the last long gap between deliveries ends") {
  Recovery recovery({planned(1, 2), planned(1.5, 2.5), planned(5, 6)}, 100);
  recovery.start(0);
  const auto deliver = [&](int64_t from_ms, int64_t to_ms) {
    for (int64_t t = from_ms; t <= to_ms; t += 10) recovery.delivered(t * kMs);
  };
  deliver(10, 500);
  deliver(700, 1200);   // a gap before all faults
  deliver(2000, 2400);  // one that ends while the second of them lasts
  deliver(2650, 4000);  // 150 ms after both
  CHECK(recovery.report() == Json{{"slowest_s", 0.15}, {"after_s", 2.5}});
  deliver(4010, 5000);
  deliver(6100, 7000);  // 100 ms after the third
  CHECK(recovery.report() == Json{{"slowest_s", 0.15}, {"after_s", 2.5}});
  deliver(7300, 7310);  // long after it, and nothing else has happened: put down to it
  CHECK(recovery.report() == Json{{"slowest_s", 1.3}, {"after_s", 6.0}});
}
