#include "framework/fault/random_faults.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "framework/fault/fault_places.h"

namespace svchain {

namespace {

constexpr int64_t kMs = 1'000'000;
constexpr int64_t kS = 1000 * kMs;

int64_t ns_of(double s) {
  return std::llround(s * 1e9);
}

/// The same numbers on every machine: whole numbers only. What <random> calls distributions, and even the
/// last digit of a logarithm, is the library's own.
class Chance {
 public:
  explicit Chance(uint64_t seed) : random_(seed) {}

  /// Both ends included. The remainder's bias is below 1e-3 for what is asked here, at most 1e15.
  int64_t between(int64_t low, int64_t high) {
    return low + static_cast<int64_t>(random_() % static_cast<uint64_t>(high - low + 1));
  }

  template <class T>
  const T& one_of(const std::vector<T>& list) {
    return list[static_cast<size_t>(random_() % list.size())];
  }

  int64_t either_way(int64_t low, int64_t high) {
    const int64_t size = between(low, high);
    return random_() % 2 == 0 ? size : -size;
  }

  /// Time to the next event of a Poisson process, by comparisons alone (von Neumann 1951): where a run of
  /// falling uniform numbers has an odd length, its first is the time; else one mean time has passed, and
  /// anew.
  int64_t exponential(int64_t mean) {
    for (int64_t passed = 0;; passed += mean) {
      const int64_t first = between(0, mean - 1);
      int length = 1;
      for (int64_t last = first, next; (next = between(0, mean - 1)) <= last; last = next) ++length;
      if (length % 2 == 1) return passed + first;
    }
  }

 private:
  std::mt19937_64 random_;
};

/// A kind with the places that chance may pick.
struct Candidate {
  FaultKind kind;
  std::vector<FaultPlace> places;
};

/// What would end the run does not happen by chance.
bool is_survived(FaultKind kind, int place, const Plan& plan) {
  if (kind != FaultKind::kThrow) return true;
  return plan.links[static_cast<size_t>(place)].entry.on_error == OnError::kDrop;
}

std::vector<Candidate> candidates(const std::vector<FaultKind>& kinds, const Plan& plan) {
  std::vector<Candidate> list;
  for (FaultKind kind : kinds) {
    Candidate candidate{kind, places_of(kind, plan)};
    std::erase_if(candidate.places, [&](const auto& p) { return !is_survived(kind, p.index, plan); });
    if (!candidate.places.empty()) list.push_back(std::move(candidate));
  }
  return list;
}

void draw_amount(Chance& chance, PlannedFault& fault) {
  const auto draw_chance = [&] { fault.chance = static_cast<double>(chance.between(100, 1000)) / 1000; };
  switch (fault.kind) {
    case FaultKind::kDropout:
    case FaultKind::kCorrupt:
    case FaultKind::kThrow:
    case FaultKind::kLost:
      return draw_chance();
    case FaultKind::kJitter:
      fault.amount_ns = chance.between(kMs, 40 * kMs);
      return draw_chance();
    case FaultKind::kWrongTimestamp:
      fault.amount_ns = chance.either_way(kMs, 10 * kS);
      return draw_chance();
    case FaultKind::kLate:
      fault.amount_ns = chance.between(kMs, 200 * kMs);
      return draw_chance();
    case FaultKind::kSlow:
      fault.factor = static_cast<double>(chance.between(2000, 10'000)) / 1000;
      return;
    case FaultKind::kClockStep:
      fault.amount_ns = chance.either_way(kMs, 2 * kS);
      return;
    case FaultKind::kFreeze:
    case FaultKind::kNoMemory:
    case FaultKind::kFull:
    case FaultKind::kHalt:
      return;
  }
}

}  // namespace

Result<std::vector<PlannedFault>> draw_faults(const RandomFaults& random, const Plan& plan, uint64_t seed) {
  std::vector<PlannedFault> faults;
  const auto list = candidates(random.kinds, plan);
  if (list.empty())
    return tl::unexpected(Faults{random.origin.fault("none of the kinds has a place in this use case")});
  Chance chance(seed);
  const int64_t mean_ns = ns_of(3600 / random.per_hour);
  const int64_t shortest_ns = ns_of(random.lasting_s[0]), longest_ns = ns_of(random.lasting_s[1]);
  const int64_t end_ns = ns_of(random.to_s);
  for (int64_t now_ns = ns_of(random.from_s);;) {
    now_ns += chance.exponential(mean_ns);
    if (now_ns >= end_ns) return faults;
    const Candidate& candidate = chance.one_of(list);
    const FaultPlace& place = chance.one_of(candidate.places);
    PlannedFault fault;
    fault.kind = candidate.kind;
    fault.place = place.index;
    fault.at = place.name;
    fault.from_ns = now_ns;
    fault.to_ns = std::min(end_ns, now_ns + chance.between(shortest_ns, longest_ns));
    draw_amount(chance, fault);
    faults.push_back(std::move(fault));
  }
}

}  // namespace svchain
