// What chains put into their traces.

#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/framework/fake_links.h"
#include "tests/framework/trace_check.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

ChainOptions traced(ChainOptions options = by_hand()) {
  options.trace_events = 100'000;
  return options;
}

/// A source that runs ahead, by the machine's clock.
ChainOptions untimed() {
  ChainOptions options = traced();
  options.pace.virtual_clock = false;
  options.pace.frames = 100;
  return options;
}

std::string dropping(const std::string& policy) {
  return line("{}", "", R"({"from":"numbers.out","to":"add.in","depth":2,"policy":")" + policy + "\"}");
}

}  // namespace

TEST_CASE("every call has one slice, and every frame between cores one arrow from call to call") {
  for (const char* tail : {"A", "B"}) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      Fakes fakes;
      auto chain = fakes.chain(loop(tail), traced());
      run_by_hand(*chain, seed);
      const TraceCheck check(*chain);
      check_calls(check, *chain);
      CHECK(check.arrows.at("numbers.out -> loop.in") == 10);
      CHECK(check.arrows.at("loop.out -> collect.in") == 10);
      CHECK(check.arrows.count("loop.echo -> add.in") == (std::string(tail) == "A" ? 1 : 0));
      CHECK(check.drops.empty());
    }
  }
}

TEST_CASE("by the machine's clock too, slices lie one behind the other and queues within their bounds") {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Fakes fakes;
    auto chain = fakes.chain(loop("A"), untimed());
    run_by_hand(*chain, seed);
    const TraceCheck check(*chain);
    check_calls(check, *chain);
    CHECK(check.arrows.at("numbers.out -> loop.in") == 100);
  }
}

TEST_CASE("drops are in the trace by their reasons, as many as the report counts") {
  uint64_t dropped_in_all = 0;
  for (const char* policy : {"drop_oldest", "drop_newest", "latest"}) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      Fakes fakes;
      auto chain = fakes.chain(dropping(policy), untimed());
      run_by_hand(*chain, seed);
      const TraceCheck check(*chain);
      check_calls(check, *chain);
      const auto report = chain->report();
      CHECK(nlohmann::json(check.drops) ==
            (check.drops.empty() ? nlohmann::json(nullptr) : report["frames"]["dropped"]));
      const auto& edge = report["edges"]["numbers.out -> add.in"];
      CHECK(check.arrows.at("numbers.out -> add.in") == report["links"]["add"]["processed"].get<uint64_t>());
      dropped_in_all += edge["full"].get<uint64_t>();
    }
  }
  CHECK(dropped_in_all > 0);
}

TEST_CASE("a call that throws has its slice and its drop, and what it did not send is no arrow") {
  Fakes fakes;
  auto chain = fakes.chain(line(R"({"throw_at":4})", R"(,"on_error":"drop")"), traced());
  run_by_hand(*chain);
  const TraceCheck check(*chain);
  CHECK(check.calls("add") == 10);
  CHECK(check.calls("collect") == 9);
  CHECK(check.drops == std::map<std::string, uint64_t>{{"error", 1}});
  CHECK(check.arrows.at("numbers.out -> add.in") == 10);
  CHECK(check.arrows.at("add.out -> collect.in") == 9);
}

TEST_CASE("a run that failed has its trace up to the end") {
  Fakes fakes;
  auto chain = fakes.chain(line(R"({"throw_at":4})"), traced());
  run_by_hand(*chain);
  REQUIRE(chain->failure());
  const TraceCheck check(*chain);
  CHECK(check.calls("add") == 5);
  CHECK(check.calls("collect") == 4);
  CHECK(check.drops.at("error") == 1);
}

TEST_CASE("slices say which frame it was, and threads which core, in the SoC's order") {
  Fakes fakes;
  auto chain = fakes.chain(line(), traced());
  run_by_hand(*chain);
  const TraceCheck check(*chain);
  std::map<std::string, std::vector<int>> frames;
  std::vector<std::string> cores;
  for (const auto& event : check.trace["traceEvents"]) {
    if (event["name"] == "thread_name") cores.push_back(event["args"]["name"]);
    if (event["ph"] == "X" && event["cat"] == "call") frames[event["name"]].push_back(event["args"]["frame"]);
  }
  CHECK(cores == std::vector<std::string>{"A", "B"});
  const std::vector<int> counted = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  CHECK(frames["add"] == counted);
  CHECK(frames["collect"] == counted);
  CHECK(check.trace["otherData"] == nlohmann::json{{"usecase", "line"},
                                                   {"soc", "duo"},
                                                   {"modelled", true},
                                                   {"links", {"numbers", "add", "collect"}},
                                                   {"delivering", {"collect"}},
                                                   {"lost_events", 0}});
}

TEST_CASE("a trace that is full still holds together, and says how much it lacks") {
  for (const size_t events : {2, 7, 20, 41, 60}) {
    Fakes fakes;
    auto options = traced();
    options.trace_events = events;
    auto chain = fakes.chain(loop("A"), options);
    run_by_hand(*chain);
    const TraceCheck check(*chain);
    CHECK(check.trace["otherData"]["lost_events"] > 0);
    CHECK(fakes.seen.size() == 10);
  }
}

TEST_CASE("a chain that is not traced has an empty trace") {
  Fakes fakes;
  auto chain = fakes.chain(line(), by_hand());
  run_by_hand(*chain);
  CHECK(chain->traced().recorders.empty());
  CHECK(TraceCheck(*chain).calls("add") == 0);
}

TEST_CASE("the same order gives the same trace, byte by byte") {
  const auto trace = [](uint64_t seed) {
    Fakes fakes;
    auto chain = fakes.chain(loop("A"), traced());
    run_by_hand(*chain, seed);
    return chrome_trace(chain->traced());
  };
  for (uint64_t seed = 0; seed < 5; ++seed) CHECK(trace(seed) == trace(seed));
}

TEST_CASE("a traced run allocates no more than one that is not traced") {
  const auto allocations = [](size_t events) {
    Fakes fakes;
    ChainOptions options = by_hand();
    options.trace_events = events;
    auto chain = fakes.chain(line(), options);
    const size_t before = allocation_count();
    run_by_hand(*chain);
    return allocation_count() - before;
  };
  CHECK(allocations(100'000) == allocations(0));
}
