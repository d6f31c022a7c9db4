#include "usecases/svchain_bench/paired.h"

#include <stdexcept>

#include "tests/catch.h"

using namespace svchain::bench;

namespace {

/// Costs what is given, one after the other, and notes who was asked.
Cost costing(std::vector<double> costs, char name, std::string& asked) {
  return [costs, name, &asked, next = size_t{0}]() mutable {
    asked += name;
    return costs[next++];
  };
}

}  // namespace

TEST_CASE("a median is the middle value, or the mean of the two in the middle") {
  CHECK(median({5, 1, 3}) == 3);
  CHECK(median({4, 1, 2, 10}) == 3);
  CHECK(median({7}) == 7);
  CHECK_THROWS_AS(median({}), std::invalid_argument);
}

TEST_CASE("a quantile lies between its neighbours as its share does") {
  CHECK(quantile({3, 1, 2}, 0) == 1);
  CHECK(quantile({3, 1, 2}, 1) == 3);
  CHECK(quantile({0, 10}, 0.25) == 2.5);
}

TEST_CASE("a comparison takes the median of the ratios within rounds, not the ratio of the medians") {
  std::string asked;
  // The machine is slow for both in one round, and for one of them in another.
  const Paired paired = measure_paired(3, costing({2, 200, 9}, 'a', asked), costing({1, 100, 1}, 'b', asked));
  CHECK(paired.ratio == 2);
  CHECK(paired.a == 9);
  CHECK(paired.b == 1);
}

TEST_CASE("a comparison says between which values half of its rounds lie") {
  std::string asked;
  const Paired paired =
      measure_paired(5, costing({5, 1, 3, 2, 4}, 'a', asked), costing({1, 1, 1, 1, 1}, 'b', asked));
  CHECK(paired.quarter == 2);
  CHECK(paired.three_quarters == 4);
}

TEST_CASE("both sides of a comparison take turns at being first") {
  std::string asked;
  measure_paired(3, costing({1, 1, 1}, 'a', asked), costing({1, 1, 1}, 'b', asked));
  CHECK(asked == "abbaab");
}

TEST_CASE("a comparison of no rounds is refused") {
  std::string asked;
  CHECK_THROWS_AS(measure_paired(0, costing({}, 'a', asked), costing({}, 'b', asked)), std::invalid_argument);
}
