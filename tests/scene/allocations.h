#pragma once
// Counts what the running thread takes from the heap.

#include <cstddef>

namespace svchain::testing {

/// How often this thread has called operator new.
size_t allocations();

}  // namespace svchain::testing
