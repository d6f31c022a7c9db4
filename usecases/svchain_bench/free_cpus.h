#pragma once
// Whether the machine does nothing else: figures of two threads mean little where it does.

namespace svchain::bench {

/// How many CPUs two busy threads get now, 2 where nobody else wants any. Takes 0.1 s.
double cpus_for_two_threads();

}  // namespace svchain::bench
