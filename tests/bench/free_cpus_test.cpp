#include "usecases/svchain_bench/free_cpus.h"

#include "tests/catch.h"

TEST_CASE("two busy threads get some of two CPUs, and no more than there are") {
  const double cpus = svchain::bench::cpus_for_two_threads();
  CHECK(cpus > 0);
  CHECK(cpus <= 2.05);  // clocks differ by their resolution
}
