#include "usecases/svchain/cost_fit.h"

#include "tests/catch.h"

using namespace svchain;
using svchain::program::fit_cost;
using svchain::program::MeasuredCalls;

namespace {

constexpr double kAreas[] = {0.5, 0.7, 1, 1.4};

/// What the figures say, at four sizes of the view; with calls that send nothing where these are wanted.
std::vector<MeasuredCalls> measured(const CallCost& cost, double input_px_per_px, double constant_input_px,
                                    bool silent_calls = false) {
  std::vector<MeasuredCalls> all;
  for (const double area : kAreas) {
    const double px = 1e6 * area, input_px = input_px_per_px * px + constant_input_px;
    all.push_back({true, input_px, px, cost.cycles(true, input_px, px)});
    if (silent_calls) all.push_back({false, input_px, 0, cost.cycles(false, input_px, 0)});
  }
  return all;
}

CallCost cost(double per_call, double per_result, double per_input_px, double per_output_px) {
  return {per_call, per_result, per_input_px, per_output_px, 0, 0, {}};
}

}  // namespace

TEST_CASE("what grows with the output is told from what every call takes") {
  const auto fit = fit_cost(measured(cost(2e5, 0, 0, 6.5), 0, 4e6));
  CHECK(fit.cost_ns.per_call == Approx(2e5));
  CHECK(fit.cost_ns.per_output_px == Approx(6.5));
  CHECK(fit.cost_ns.per_input_px == 0);  // as many in every call: not told from per_call
  CHECK(fit.largest_deviation < 1e-3);
}

TEST_CASE("work done once comes out per result, and not with the calls that send nothing") {
  const auto fit = fit_cost(measured(cost(300, 8e7, 0, 0), 0, 4e6, true));
  CHECK(fit.cost_ns.per_call == Approx(300));
  CHECK(fit.cost_ns.per_result == Approx(8e7));
  CHECK(fit.cost_ns.per_output_px == 0);
}

TEST_CASE("a sink costs by its input, and a link that changes pictures by its output alone") {
  std::vector<MeasuredCalls> sink;
  for (const double area : kAreas) sink.push_back({false, 1e6 * area, 0, 1000 + 2e6 * area});
  CHECK(fit_cost(sink).cost_ns.per_input_px == Approx(2).epsilon(1e-3));
  const auto filter = fit_cost(measured(cost(0, 0, 1, 1), 1, 0));
  CHECK(filter.cost_ns.per_output_px == Approx(2));
  CHECK(filter.cost_ns.per_input_px == 0);
}

TEST_CASE("what falls while the output grows has no negative figure, and says how badly it fits") {
  std::vector<MeasuredCalls> falling;
  for (const double area : kAreas) falling.push_back({true, 0, 1e6 * area, 1e6 / area});
  const auto fit = fit_cost(falling);
  CHECK(fit.cost_ns.per_output_px == 0);
  CHECK(fit.cost_ns.per_call > 0);
  CHECK(fit.largest_deviation > 0.2);
}
