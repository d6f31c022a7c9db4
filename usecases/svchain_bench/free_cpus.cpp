#include "usecases/svchain_bench/free_cpus.h"

#include <ctime>
#include <thread>

#include "usecases/svchain_bench/round_trips.h"

namespace svchain::bench {

namespace {

constexpr int64_t kLookNs = 100'000'000;

int64_t thread_cpu_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return time.tv_sec * int64_t{1'000'000'000} + time.tv_nsec;
}

/// The share of a CPU that this thread gets.
double share_of_cpu() {
  const int64_t start_ns = now_ns(), cpu_start_ns = thread_cpu_ns();
  while (now_ns() - start_ns < kLookNs) {
  }
  return static_cast<double>(thread_cpu_ns() - cpu_start_ns) / static_cast<double>(now_ns() - start_ns);
}

}  // namespace

double cpus_for_two_threads() {
  double others = 0;
  std::thread other([&] { others = share_of_cpu(); });
  const double own = share_of_cpu();
  other.join();
  return own + others;
}

}  // namespace svchain::bench
