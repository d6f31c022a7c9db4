#pragma once
// Counts every operator new of the test's program.

#include <cstddef>

namespace svchain::testing {

size_t allocation_count();

}  // namespace svchain::testing
