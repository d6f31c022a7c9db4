#include "framework/statistics/counter.h"
#include "framework/statistics/drop_counts.h"
#include "tests/catch.h"

using namespace svchain;

TEST_CASE("quantiles of a histogram are right to 7 %, the maximum exactly") {
  Histogram h;
  for (int64_t v = 1; v <= 100'000; ++v) h.record(v);
  CHECK(h.count() == 100'000);
  CHECK(h.max_ns() == 100'000);
  CHECK(static_cast<double>(h.quantile_ns(0.5)) == Approx(50'000).epsilon(0.07));
  CHECK(static_cast<double>(h.quantile_ns(0.99)) == Approx(99'000).epsilon(0.07));
  CHECK(h.quantile_ns(1.0) == 100'000);
}

TEST_CASE("a histogram takes what no clock should give") {
  Histogram h;
  CHECK(h.quantile_ns(0.5) == 0);
  h.record(-5);
  h.record(std::numeric_limits<int64_t>::max());
  CHECK(h.count() == 2);
  CHECK(h.quantile_ns(0.5) == 0);
  CHECK(h.max_ns() == std::numeric_limits<int64_t>::max());
}

TEST_CASE("drops are counted by reason, and none is lost when there are many reasons") {
  DropCounts drops;
  const char* reasons[] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n"};
  for (const char* reason : reasons) drops.add(reason, 2);
  drops.add("a");
  CHECK(drops.by_reason().at("a") == 3);
  CHECK(drops.total() == 29);
}
