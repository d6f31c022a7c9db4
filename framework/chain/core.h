#pragma once
// A core: the links placed on it, run one call at a time, nearest to the sink first (so that frames leave
// before new ones come in). Its inbox is the rings of its IPC edges, the rings of returned buffers and a
// mailbox for commands; its doorbell tells it to look. A core is stepped by one thread at a time: its own, or
// a manual executor's.

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "framework/buffer/holder.h"
#include "framework/chain/runner.h"
#include "framework/clock/clock.h"

namespace svchain {

class Core {
 public:
  /// Picks one of n ready links; empty: the one nearest to the sink.
  using Choice = std::function<size_t(size_t n)>;

  Core(int index, std::string name, ipc::Doorbell& doorbell, const Clock& clock, int runners);

  // Before the chain runs:
  /// In the order of precedence; `position` of the first is 0.
  void add(Runner& runner);
  void add_returns(ipc::Ring<ReturnedBuffer> ring) { returns_.push_back(ring); }
  void set_pools(const PoolTable& pools) { pools_ = &pools; }

  const std::string& name() const { return name_; }
  int index() const { return index_; }
  Attention& attention() { return attention_; }
  ipc::Doorbell& doorbell() { return doorbell_; }

  // The stepping thread:
  /// Does what has been posted and calls one ready link; false if there was none.
  bool step(const Choice& choice = {});
  /// Steps until quit() and parks when there is nothing to do.
  void loop(int spins, bool parks);
  /// The earliest time at which a source here wants to be called.
  std::optional<int64_t> next_wake_ns() const;
  void take_returns();

  // Any thread:
  /// Runs on the core between two calls.
  void post(std::function<void()> work);
  void quit();
  int64_t busy_ns() const { return static_cast<int64_t>(busy_ns_.value()); }
  uint64_t calls() const { return calls_.value(); }
  /// In the middle of a link's call.
  bool busy() const { return busy_.load(std::memory_order_relaxed); }

 private:
  void look_around();
  Runner* next_ready(const Choice& choice);
  void run_posted();

  int index_;
  std::string name_;
  ipc::Doorbell& doorbell_;
  const Clock& clock_;
  Attention attention_;
  std::vector<Runner*> runners_;
  std::vector<size_t> sources_;  // positions of those that call themselves
  std::vector<Runner*> ready_;   // scratch for a choice
  std::vector<ipc::Ring<ReturnedBuffer>> returns_;
  const PoolTable* pools_ = nullptr;

  uint32_t seen_epoch_ = ~0u;
  int64_t now_ns_ = 0;
  bool now_is_fresh_ = false;
  Counter busy_ns_, calls_;
  std::atomic<bool> busy_{false};
  std::atomic<bool> quit_{false};

  std::mutex mailbox_mutex_;
  std::vector<std::function<void()>> mailbox_;
  std::atomic<bool> has_mail_{false};
};

}  // namespace svchain
