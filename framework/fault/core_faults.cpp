#include "framework/fault/core_faults.h"

namespace svchain {

namespace {

/// Whatever needs that place waits until the fault is over.
bool hinders(FaultKind kind) {
  return kind == FaultKind::kHalt || kind == FaultKind::kFull || kind == FaultKind::kNoMemory;
}

}  // namespace

void CoreFaults::add(InjectedFault& fault, FaultSite& site) {
  const PlannedFault& planned = *fault.planned;
  changes_.push_back({planned.from_ns, &fault, &site, true});
  if (planned.to_ns < PlannedFault::kNever) changes_.push_back({planned.to_ns, &fault, &site, false});
}

/// At one time what ends comes first.
void CoreFaults::start(int64_t now_ns) {
  std::stable_sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    return a.at_ns != b.at_ns ? a.at_ns < b.at_ns : a.begins < b.begins;
  });
  for (Change& change : changes_) change.at_ns += now_ns;
  next_ns_ = changes_.empty() ? kNever : changes_.front().at_ns;
}

bool CoreFaults::advance(int64_t now_ns) {
  const bool was_halted = halted();
  for (; next_ < changes_.size() && changes_[next_].at_ns <= now_ns; ++next_) {
    const Change& change = changes_[next_];
    const PlannedFault& planned = *change.fault->planned;
    change.begins ? change.site->begin(*change.fault) : change.site->end(*change.fault);
    if (planned.kind == FaultKind::kClockStep)
      clock_offset_ns_ += change.begins ? planned.amount_ns : -planned.amount_ns;
    if (svchain::hinders(planned.kind) && planned.to_ns < PlannedFault::kNever)
      hindrances_ += change.begins ? 1 : -1;
    if (change.begins && (svchain::hinders(planned.kind) || planned.kind == FaultKind::kClockStep))
      change.fault->times.add();
  }
  next_ns_ = next_ < changes_.size() ? changes_[next_].at_ns : kNever;
  return was_halted && !halted();
}

}  // namespace svchain
