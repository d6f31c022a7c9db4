#include "framework/chain/workers.h"

#include <utility>

namespace svchain {

namespace {

constexpr uint64_t ticket(uint32_t round, int part) {
  return uint64_t{round} << 32 | static_cast<uint32_t>(part);
}

}  // namespace

Workers::Workers(int helpers) {
  helpers_.reserve(static_cast<size_t>(helpers));
  for (int i = 0; i < helpers; ++i) helpers_.emplace_back([this] { help(); });
}

Workers::~Workers() {
  quit_ = true;
  ++round_;
  round_.notify_all();
  for (auto& helper : helpers_) helper.join();
}

void Workers::run(int count, Part part, const void* context) {
  const uint32_t round = round_.load(std::memory_order_relaxed) + 1;
  Job& job = jobs_[round % 2];
  job.count.store(count, std::memory_order_relaxed);
  job.part.store(part, std::memory_order_relaxed);
  job.context.store(context, std::memory_order_relaxed);
  done_.store(0, std::memory_order_relaxed);
  tickets_.store(ticket(round, 0), std::memory_order_release);
  round_.store(round, std::memory_order_release);
  round_.notify_all();

  work_on(round);
  for (int done = done_.load(std::memory_order_acquire); done != count;
       done = done_.load(std::memory_order_acquire))
    done_.wait(done, std::memory_order_acquire);
  if (!failed_.test(std::memory_order_acquire)) return;
  failed_.clear();
  std::rethrow_exception(std::exchange(exception_, nullptr));
}

void Workers::help() {
  for (uint32_t seen = 0;;) {
    round_.wait(seen, std::memory_order_acquire);
    if (quit_) return;
    seen = round_.load(std::memory_order_acquire);
    work_on(seen);
  }
}

/// A ticket that is taken while it is of this round proves that the job read before is this round's: the next
/// one begins only when all parts are done. A later round's tickets are left alone.
void Workers::work_on(uint32_t round) {
  const Job& job = jobs_[round % 2];
  const int count = job.count.load(std::memory_order_relaxed);
  const Part part = job.part.load(std::memory_order_relaxed);
  const void* const context = job.context.load(std::memory_order_relaxed);
  uint64_t next = tickets_.load(std::memory_order_acquire);
  while (next >> 32 == round && static_cast<int>(next & 0xFFFFFFFF) < count) {
    if (!tickets_.compare_exchange_weak(next, next + 1, std::memory_order_acq_rel)) continue;
    try {
      part(context, static_cast<int>(next & 0xFFFFFFFF));
    } catch (...) {
      note_exception();
    }
    if (done_.fetch_add(1, std::memory_order_acq_rel) + 1 == count) done_.notify_one();
    next = tickets_.load(std::memory_order_acquire);
  }
}

void Workers::note_exception() {
  if (!failed_.test_and_set(std::memory_order_acq_rel)) exception_ = std::current_exception();
}

}  // namespace svchain
