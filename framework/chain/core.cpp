#include "framework/chain/core.h"

#include <bit>

namespace svchain {

Core::Core(int index, std::string name, ipc::Doorbell& doorbell, const Clock& clock, int runners)
    : index_(index), name_(std::move(name)), doorbell_(doorbell), clock_(clock), attention_(runners) {
  runners_.reserve(static_cast<size_t>(runners));
  ready_.reserve(static_cast<size_t>(runners));
}

void Core::add(Runner& runner) {
  if (runner.is_source()) sources_.push_back(runners_.size());
  runners_.push_back(&runner);
}

bool Core::step(const Choice& choice) {
  if (const uint32_t epoch = doorbell_.epoch(); epoch != seen_epoch_) {
    seen_epoch_ = epoch;
    look_around();
  }
  if (!now_is_fresh_) now_ns_ = clock_.now_ns();
  now_is_fresh_ = false;
  for (const size_t source : sources_) {
    if (runners_[source]->wake_time_ns() <= now_ns_) attention_.mark(static_cast<int>(source));
  }
  Runner* runner = next_ready(choice);
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

/// Another core has changed something: which links it concerns is found out by looking at them all.
void Core::look_around() {
  take_returns();
  if (has_mail_.load(std::memory_order_acquire)) run_posted();
  for (size_t i = 0; i < runners_.size(); ++i) attention_.mark(static_cast<int>(i));
}

Runner* Core::next_ready(const Choice& choice) {
  ready_.clear();
  const auto& words = attention_.words();
  for (size_t w = 0; w < words.size(); ++w) {
    for (uint64_t left = words[w]; left != 0; left &= left - 1) {
      const size_t i = w * 64 + static_cast<size_t>(std::countr_zero(left));
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

void Core::loop(int spins, bool parks) {
  while (!quit_.load(std::memory_order_acquire)) {
    if (step()) continue;
    std::optional<std::chrono::nanoseconds> timeout;
    if (!parks) timeout = std::chrono::nanoseconds(0);
    if (const auto wake = next_wake_ns(); wake && parks)
      timeout = std::chrono::nanoseconds(*wake - clock_.now_ns());
    doorbell_.wait(seen_epoch_, spins, timeout);
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

void Core::take_returns() {
  for (auto& ring : returns_) {
    ReturnedBuffer returned;
    while (ring.pop(returned)) (*pools_)[returned.buffer.pool]->give_back(returned.buffer.index);
  }
}

void Core::post(std::function<void()> work) {
  {
    const std::lock_guard lock(mailbox_mutex_);
    mailbox_.push_back(std::move(work));
  }
  has_mail_.store(true, std::memory_order_release);
  doorbell_.ring();
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
  doorbell_.ring();
}

}  // namespace svchain
