#include "usecases/svchain_bench/pinned.h"

#include <sched.h>

namespace svchain::bench {

namespace {

/// What the program may use; asked before anything is pinned.
const cpu_set_t& cpus() {
  static const cpu_set_t all = [] {
    cpu_set_t set;
    CPU_ZERO(&set);
    sched_getaffinity(0, sizeof(set), &set);
    return set;
  }();
  return all;
}

}  // namespace

void pin(int end) {
  if (CPU_COUNT(&cpus()) < 2) return;
  int cpu = 0;
  for (int before = 0; !CPU_ISSET(cpu, &cpus()) || before < end; ++cpu) before += CPU_ISSET(cpu, &cpus());
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(cpu, &one);
  sched_setaffinity(0, sizeof(one), &one);
}

Pinned::~Pinned() {
  sched_setaffinity(0, sizeof(cpus()), &cpus());
}

}  // namespace svchain::bench
