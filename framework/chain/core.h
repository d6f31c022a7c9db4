#pragma once
// A core: the links placed on it, run one call at a time, nearest to the sink first (so that frames leave
// before new ones come in). Its inbox is the rings of its IPC edges and a mailbox for commands; the bells of
// its doorbell tell it for which links to look. A core is stepped by one thread at a time: its own, or a
// manual executor's.

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "framework/buffer/attention.h"
#include "framework/chain/runner.h"
#include "framework/clock/clock.h"

namespace svchain {

class alignas(ipc::kCacheLine) Core {
 public:
  /// Picks one of n ready links; empty: the one nearest to the sink.
  using Choice = std::function<size_t(size_t n)>;

  Core(int index, std::string name, ipc::Doorbell& doorbell, const Clock& clock, int runners);

  // Before the chain runs:
  /// In the order of precedence; `position` of the first is 0.
  void add(Runner& runner);
  /// An edge that comes from another core.
  void add_arrivals(Edge& edge) { arrivals_.push_back(&edge); }
  /// What goes wrong here and on the edges that leave its links.
  void set_faults(CoreFaults& faults, std::vector<Edge*> departures);

  const std::string& name() const { return name_; }
  int index() const { return index_; }
  Attention& attention() { return attention_; }

  // The stepping thread:
  /// Does what has been posted and calls one ready link; false if there was none.
  bool step(const Choice& choice = {});
  /// The ready link that comes next, after doing what has been posted; null if there is none.
  Runner* next(const Choice& choice = {});
  /// In modelled time: a call has ended.
  void count_call(int64_t busy_ns) {
    busy_ns_.add(static_cast<uint64_t>(busy_ns));
    calls_.add();
  }
  /// Steps until quit() and parks when there is nothing to do.
  void loop(int spins, bool parks);
  /// Begins and ends the faults that are due.
  void look_at_faults(int64_t now_ns);
  /// The earliest time at which a source here wants to be called, a lost state has to be sent again, or a
  /// fault begins or ends.
  std::optional<int64_t> next_wake_ns() const;
  /// The second of these alone.
  std::optional<int64_t> next_fault_ns() const { return faults_ ? faults_->next_change_ns() : std::nullopt; }

  // Any thread:
  /// Has it look at all of its links.
  void wake() { doorbell_.ring(kBellOfAll); }
  /// Runs on the core between two calls.
  void post(std::function<void()> work);
  void quit();
  int64_t busy_ns() const { return static_cast<int64_t>(busy_ns_.value()); }
  uint64_t calls() const { return calls_.value(); }
  /// In the middle of a link's call, or held up by a fault that will be over.
  bool busy() const { return busy_.load(std::memory_order_relaxed); }

 private:
  void answer(uint32_t bells);
  bool arrived();
  Runner* next_ready(const Choice& choice);
  void run_posted();

  int index_;
  std::string name_;
  ipc::Doorbell& doorbell_;
  const Clock& clock_;
  Attention attention_;
  std::vector<Runner*> runners_;
  std::vector<size_t> sources_;  // positions of those that call themselves
  std::vector<size_t> keepers_;  // and of those that may have to send a state again
  std::vector<Runner*> ready_;   // scratch for a choice
  std::vector<Edge*> arrivals_;
  size_t next_arrival_ = 0;       // whose turn it is to be looked at while the core spins
  CoreFaults* faults_ = nullptr;  // null: nothing goes wrong here
  std::vector<Edge*> departures_;

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
