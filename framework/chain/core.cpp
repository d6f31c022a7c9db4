#include "framework/chain/core.h"

#include <algorithm>
#include <bit>

namespace svchain {

Core::Core(int index, std::string name, ipc::Doorbell& doorbell, const Clock& clock, int runners)
    : index_(index), name_(std::move(name)), doorbell_(doorbell), clock_(clock), attention_(runners) {
  runners_.reserve(static_cast<size_t>(runners));
  ready_.reserve(static_cast<size_t>(runners));
}

void Core::add(Runner& runner) {
  if (runner.is_source()) sources_.push_back(runners_.size());
  attention_.mark(static_cast<int>(runners_.size()));
  runners_.push_back(&runner);
}

Runner* Core::next(const Choice& choice) {
  if (const uint32_t bells = doorbell_.take()) answer(bells);
  if (!now_is_fresh_) now_ns_ = clock_.now_ns();
  now_is_fresh_ = false;
  for (const size_t source : sources_) {
    if (runners_[source]->wake_time_ns() <= now_ns_) attention_.mark(static_cast<int>(source));
  }
  return next_ready(choice);
}

bool Core::step(const Choice& choice) {
  Runner* runner = next(choice);
  if (!runner) return false;

  busy_.store(true, std::memory_order_relaxed);
  const int64_t end_ns = runner->run(now_ns_);
  busy_.store(false, std::memory_order_relaxed);
  busy_ns_.add(static_cast<uint64_t>(end_ns - now_ns_));
  calls_.add();
  now_ns_ = end_ns;
  now_is_fresh_ = true;  // one look at the clock serves as the end of this call and the start of the next
  return true;
}

/// Another core has changed something for the links of these bells.
void Core::answer(uint32_t bells) {
  const int count = static_cast<int>(runners_.size());
  if (bells >> kBellOfAll) {
    if (has_mail_.load(std::memory_order_acquire)) run_posted();
    for (int i = 0; i < count; ++i) attention_.mark(i);
    return;
  }
  for (; bells != 0; bells &= bells - 1) {
    for (int i = std::countr_zero(bells); i < count; i += kBellOfAll) attention_.mark(i);
  }
}

/// While it spins it looks at the rings themselves, one a time: what lies there is seen before the bell.
bool Core::arrived() {
  if (arrivals_.empty()) return false;
  if (++next_arrival_ >= arrivals_.size()) next_arrival_ = 0;
  Edge& edge = *arrivals_[next_arrival_];
  if (!edge.arrived()) return false;
  attention_.mark(edge.consumer().runner);
  return true;
}

Runner* Core::next_ready(const Choice& choice) {
  ready_.clear();
  for (size_t w = 0; w < attention_.words(); ++w) {
    for (uint64_t left = attention_.word(w); left != 0; left &= left - 1) {
      const size_t i = w * Attention::kWordBits + static_cast<size_t>(std::countr_zero(left));
      if (!runners_[i]->waiting(now_ns_).ready()) {
        attention_.clear(static_cast<int>(i));
        continue;
      }
      if (!choice) return runners_[i];
      ready_.push_back(runners_[i]);
    }
  }
  return ready_.empty() ? nullptr : ready_[choice(ready_.size())];
}

/// Two cores that keep each other waiting for less than a wake-up takes would do so for ever, each asleep
/// when the other rings. So whoever was woken soon after it had parked is more patient the next time.
void Core::loop(int spins, bool parks) {
  constexpr int kMostPatient = 8;
  constexpr int64_t kSoon_ns = 50'000;  // a wake-up takes 5 to 20 us
  int patience = 1;
  while (!quit_.load(std::memory_order_acquire)) {
    if (step() || doorbell_.spin(patience * spins, [this] { return arrived(); }) || !parks) continue;
    const int64_t parked_ns = clock_.now_ns();
    std::optional<std::chrono::nanoseconds> timeout;
    if (const auto wake = next_wake_ns()) timeout = std::chrono::nanoseconds(*wake - parked_ns);
    if (!doorbell_.park(timeout)) continue;
    const bool soon = clock_.now_ns() - parked_ns < kSoon_ns;
    patience = soon ? std::min(2 * patience, kMostPatient) : 1;
  }
}

std::optional<int64_t> Core::next_wake_ns() const {
  std::optional<int64_t> earliest;
  for (const size_t source : sources_) {
    Runner& runner = *runners_[source];
    if (runner.waiting(now_ns_).what != Runner::Wait::kTime) continue;
    if (!earliest || runner.wake_time_ns() < *earliest) earliest = runner.wake_time_ns();
  }
  return earliest;
}

void Core::post(std::function<void()> work) {
  {
    const std::lock_guard lock(mailbox_mutex_);
    mailbox_.push_back(std::move(work));
  }
  has_mail_.store(true, std::memory_order_release);
  wake();
}

void Core::run_posted() {
  std::vector<std::function<void()>> work;
  {
    const std::lock_guard lock(mailbox_mutex_);
    work.swap(mailbox_);
    has_mail_.store(false, std::memory_order_relaxed);
  }
  for (auto& w : work) w();
}

void Core::quit() {
  quit_.store(true, std::memory_order_release);
  wake();
}

}  // namespace svchain
