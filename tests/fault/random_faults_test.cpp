#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>

#include "framework/fault/fault_plan.h"
#include "tests/catch.h"
#include "tests/usecase/expect.h"

namespace svchain {

namespace {

constexpr int64_t kMs = 1'000'000;

/// With a place for every kind: "b" may throw, and what it sends may be lost.
Plan small_plan() {
  auto plan =
      testing::plan_of(testing::text_of({R"("a": {"type": "capture", "core": "IPU1"})",
                                         R"("b": {"type": "gain", "core": "IPU1", "on_error": "drop"})",
                                         R"("c": {"type": "null", "core": "DSP1"})"},
                                        {R"("a.front -> b.in")", R"("b.out -> c.in")"}));
  REQUIRE(plan);
  return *std::move(plan);
}

Plan two_dsps() {
  auto plan = testing::plan_of(testing::kTwoDsps);
  REQUIRE(plan);
  return *std::move(plan);
}

FaultPlan drawn(const std::string& members, const Plan& plan, uint64_t seed) {
  const auto script = parse_fault_script("{\"random\": {" + members + "}}", "f.json");
  if (!script) FAIL(script.error().front().text());
  auto result = place_faults(*script, plan, seed);
  if (!result) FAIL(result.error().front().text());
  return *std::move(result);
}

auto all_of(const PlannedFault& f) {
  return std::tuple(f.kind, f.place, f.at, f.from_ns, f.to_ns, f.chance, f.amount_ns, f.factor);
}

bool same(const FaultPlan& a, const FaultPlan& b) {
  return std::equal(a.faults.begin(), a.faults.end(), b.faults.begin(), b.faults.end(),
                    [](const auto& x, const auto& y) { return all_of(x) == all_of(y); });
}

const std::string kHours = R"("per_hour": 120, "from_s": 10, "to_s": 36010)";  // ten hours

}  // namespace

TEST_CASE("the same seed draws the same faults, another seed others") {
  const Plan plan = two_dsps();
  const FaultPlan first = drawn(kHours, plan, 7);
  CHECK(first.seed == 7);
  CHECK(first.faults.size() > 1000);
  CHECK(same(first, drawn(kHours, plan, 7)));
  CHECK_FALSE(same(first, drawn(kHours, plan, 8)));
}

TEST_CASE("random faults begin as often as was asked for, and as a Poisson process does") {
  const Plan plan = two_dsps();
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const auto faults = drawn(R"("per_hour": 600, "to_s": 360000)", plan, seed).faults;  // 60 000 in the mean
    CHECK(static_cast<double>(faults.size()) == Approx(60'000).margin(4 * std::sqrt(60'000)));
    // Of exponential gaps exp(-1) are longer than the mean, and exp(-3) longer than three.
    const auto longer = [&](double means) {
      size_t n = 0;
      for (size_t i = 1; i < faults.size(); ++i)
        n += static_cast<double>(faults[i].from_ns - faults[i - 1].from_ns) > means * 6e9;
      return static_cast<double>(n) / static_cast<double>(faults.size());
    };
    CHECK(longer(1) == Approx(std::exp(-1.0)).margin(0.01));
    CHECK(longer(3) == Approx(std::exp(-3.0)).margin(0.005));
  }
}

TEST_CASE("random faults lie within their time, in order, and last as long as was said") {
  const auto faults = drawn(kHours + R"(, "lasting_s": [0.5, 1.5])", two_dsps(), 3).faults;
  CHECK(std::is_sorted(faults.begin(), faults.end(),
                       [](const auto& a, const auto& b) { return a.from_ns < b.from_ns; }));
  for (const PlannedFault& fault : faults) {
    CHECK(fault.from_ns >= 10'000 * kMs);
    CHECK(fault.to_ns <= 36'010'000 * kMs);
    CHECK(fault.to_ns - fault.from_ns <= 1500 * kMs);
    if (fault.to_ns < 36'010'000 * kMs) CHECK(fault.to_ns - fault.from_ns >= 500 * kMs);
  }
}

TEST_CASE("random faults are of the kinds asked for only, all kinds about as often") {
  const Plan plan = small_plan();
  for (const PlannedFault& fault : drawn(kHours + R"(, "kinds": ["halt", "late"])", plan, 1).faults)
    CHECK((fault.kind == FaultKind::kHalt || fault.kind == FaultKind::kLate));
  std::map<FaultKind, int> counts;
  for (const PlannedFault& fault : drawn(R"("per_hour": 1300, "to_s": 36000)", plan, 1).faults)
    ++counts[fault.kind];
  CHECK(counts.size() == kFaultKinds);
  for (const auto& [kind, count] : counts) {
    INFO(name_of(kind));
    CHECK(count == Approx(1000).margin(150));
  }
}

TEST_CASE("amounts of random faults are within what the file format says") {
  const auto within = [](int64_t value, int64_t low, int64_t high) {
    return std::abs(value) >= low && std::abs(value) <= high;
  };
  std::map<FaultKind, int> negative;
  for (const PlannedFault& fault : drawn(R"("per_hour": 1300, "to_s": 36000)", small_plan(), 2).faults) {
    INFO(name_of(fault.kind));
    CHECK((fault.chance >= 0.1 && fault.chance <= 1));
    negative[fault.kind] += fault.amount_ns < 0;
    if (fault.kind == FaultKind::kJitter) CHECK(within(fault.amount_ns, kMs, 40 * kMs));
    if (fault.kind == FaultKind::kWrongTimestamp) CHECK(within(fault.amount_ns, kMs, 10'000 * kMs));
    if (fault.kind == FaultKind::kLate) CHECK(within(fault.amount_ns, kMs, 200 * kMs));
    if (fault.kind == FaultKind::kClockStep) CHECK(within(fault.amount_ns, kMs, 2000 * kMs));
    if (fault.kind == FaultKind::kSlow) CHECK((fault.factor >= 2 && fault.factor <= 10));
    if (fault.kind == FaultKind::kHalt) CHECK(fault.chance == 1);
  }
  CHECK(negative[FaultKind::kWrongTimestamp] > 400);
  CHECK(negative[FaultKind::kClockStep] > 400);
  CHECK(negative[FaultKind::kJitter] + negative[FaultKind::kLate] == 0);
}

TEST_CASE("links whose policy is to stop do not throw at random") {
  for (const PlannedFault& fault : drawn(kHours + R"(, "kinds": ["throw"])", small_plan(), 1).faults)
    CHECK(fault.at == "b");
  for (const PlannedFault& fault : drawn(kHours, two_dsps(), 1).faults)
    CHECK(fault.kind != FaultKind::kThrow);
}

TEST_CASE("messages get lost at random on every edge") {
  std::map<std::string, int> lost;
  for (const PlannedFault& fault : drawn(kHours + R"(, "kinds": ["lost"])", two_dsps(), 1).faults)
    ++lost[fault.at];
  CHECK(lost.size() == two_dsps().edges.size());
}

TEST_CASE("random faults without any place are refused at their entry") {
  const auto script =
      parse_fault_script("{\n\"random\": {\"per_hour\": 1, \"to_s\": 9, \"kinds\": [\"throw\"]}}", "f.json");
  REQUIRE(script);
  const auto result = place_faults(*script, two_dsps(), 1);
  REQUIRE_FALSE(result);
  testing::check_fault(result.error(), "f.json:2:11: error: /random",
                       {"none of the kinds has a place in this use case"});
}

TEST_CASE("the random faults of a seed are the same on every machine") {
  const auto faults = drawn(R"("per_hour": 120, "to_s": 3600)", two_dsps(), 1).faults;
  REQUIRE(faults.size() > 3);  // the values below are from a program of their own, in another language
  CHECK(all_of(faults[0]) ==
        std::tuple(FaultKind::kNoMemory, 4, "synthesis", 9'546'311'528, 10'227'792'811, 1.0, 0, 1.0));
  CHECK(all_of(faults[1]) ==
        std::tuple(FaultKind::kCorrupt, 0, "capture.front", 38'879'317'937, 40'326'004'113, 0.49, 0, 1.0));
  CHECK(all_of(faults[2]) == std::tuple(FaultKind::kClockStep, -1, "clock", 139'147'259'125, 140'222'403'325,
                                        1.0, 1'433'341'055, 1.0));
}

}  // namespace svchain
