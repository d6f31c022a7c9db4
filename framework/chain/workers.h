#pragma once
// The further CPUs of a core that has more than one: threads that help its own with work that falls into
// parts. Parts are taken by whoever is free, so which thread does which is not defined; what they write must
// not depend on it. The core's thread works as well, and waits for parts, never for threads: a helper that
// the system lets sleep costs nothing.
//
// run() belongs to the core's thread, and neither allocates nor locks. Helpers sleep between runs.

#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

namespace svchain {

class Workers {
 public:
  using Part = void (*)(const void* context, int part);

  /// `helpers`: threads besides the caller of run().
  explicit Workers(int helpers);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Helpers and the caller.
  int cpus() const { return static_cast<int>(helpers_.size()) + 1; }

  /// part(context, 0) ... part(context, count - 1), all done when it returns. What the first one to throw
  /// threw is thrown again, after all of them.
  void run(int count, Part part, const void* context);

 private:
  /// Written by run() before its round begins; two, so that a helper that is late reads nothing that changes.
  struct Job {
    std::atomic<int> count{0};
    std::atomic<Part> part{nullptr};
    std::atomic<const void*> context{nullptr};
  };

  void help();
  /// Takes parts of this round until there are none left.
  void work_on(uint32_t round);
  void note_exception();

  std::array<Job, 2> jobs_;           // by parity of the round
  std::atomic<uint64_t> tickets_{0};  // round in the upper half, next part in the lower
  std::atomic<uint32_t> round_{0};    // helpers wait for it to change
  std::atomic<int> done_{0};          // parts of this round
  std::atomic<bool> quit_{false};
  std::atomic_flag failed_ = ATOMIC_FLAG_INIT;
  std::exception_ptr exception_;  // its writer holds failed_ and has a part that is not done
  std::vector<std::thread> helpers_;
};

}  // namespace svchain
