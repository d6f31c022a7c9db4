#pragma once
// Keeps the threads at the ends of a hop on a CPU each. Left to the scheduler they sometimes share one, and a
// hop costs something else altogether. The calling thread's own affair; threads that it makes inherit it.

namespace svchain::bench {

/// From here on the thread runs on the CPU of this end (0 or 1), where the machine has two for us.
void pin(int end);

/// The same until the object goes: then on any CPU again that the program may use.
class Pinned {
 public:
  explicit Pinned(int end) { pin(end); }
  ~Pinned();
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;
};

}  // namespace svchain::bench
