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
  if (runner.keeps_newest()) keepers_.push_back(runners_.size());
  attention_.mark(static_cast<int>(runners_.size()));
  runners_.push_back(&runner);
}

Runner* Core::next(const Choice& choice) {
  if (const uint32_t bells = doorbell_.take()) answer(bells);
  if (!now_is_fresh_) now_ns_ = clock_.now_ns();
  now_is_fresh_ = false;
  if (faults_) {
    look_at_faults(now_ns_);
    if (faults_->halted()) return nullptr;
  }
  for (const size_t source : sources_) {
    if (runners_[source]->wake_time_ns() <= now_ns_) attention_.mark(static_cast<int>(source));
  }
  for (const size_t keeper : keepers_) {
    if (runners_[keeper]->send_again_ns() <= now_ns_) attention_.mark(static_cast<int>(keeper));
  }
  return next_ready(choice);
}

bool Core::step(const Choice& choice) {
  Runner* runner = next(choice);
  if (!runner) return false;

  busy_.store(true, std::memory_order_relaxed);
  const int64_t end_ns = runner->run(now_ns_);
  busy_.store(faults_ && faults_->hinders(), std::memory_order_relaxed);
  busy_ns_.add(static_cast<uint64_t>(end_ns - now_ns_));
  calls_.add();
  now_ns_ = end_ns;
  now_is_fresh_ = true;  // one look at the clock serves as the end of this call and the start of the next
  return true;
}

void Core::set_faults(CoreFaults& faults, std::vector<Edge*> departures) {
  faults_ = &faults;
  departures_ = std::move(departures);
}

void Core::look_at_faults(int64_t now_ns) {
  if (!faults_ || !faults_->due(now_ns)) return;
  const bool starts_again = faults_->advance(now_ns);
  busy_.store(faults_->hinders(), std::memory_order_relaxed);
  if (faults_->halted()) return;
  if (starts_again)
    for (Runner* runner : runners_) runner->restart();
  for (Edge* edge : departures_) edge->send_late(now_ns);
  for (size_t i = 0; i < runners_.size(); ++i) attention_.mark(static_cast<int>(i));
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
  std::optional<int64_t> earliest = faults_ ? faults_->next_change_ns() : std::nullopt;
  if (faults_ && faults_->halted()) return earliest;
  for (const size_t source : sources_) {
    Runner& runner = *runners_[source];
    if (runner.waiting(now_ns_).what != Runner::Wait::kTime) continue;
    if (!earliest || runner.wake_time_ns() < *earliest) earliest = runner.wake_time_ns();
  }
  for (const size_t keeper : keepers_) {
    const int64_t again_ns = runners_[keeper]->send_again_ns();
    if (again_ns < earliest.value_or(Runner::kNever)) earliest = again_ns;
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
