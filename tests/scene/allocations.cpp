#include "tests/scene/allocations.h"

#include <cstdlib>
#include <new>

namespace {
thread_local size_t count = 0;
}

namespace svchain::testing {

size_t allocations() {
  return count;
}

}  // namespace svchain::testing

void* operator new(std::size_t size) {
  ++count;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
