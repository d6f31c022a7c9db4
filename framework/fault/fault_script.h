#pragma once
// A fault file: what breaks in a run, where and when. As it is written; place_faults() (fault_plan.h) finds
// the places in a plan. Plain values.
//
//   {"faults": [{"kind": "dropout", "at": "capture.left", "from_s": 2, "to_s": 3},
//               {"kind": "slow", "at": "synthesis", "from_s": 4, "to_s": 5, "factor": 3},
//               {"kind": "lost", "at": "sync.frames -> dup.in", "chance": 0.1}],
//    "random": {"per_hour": 60, "from_s": 10, "to_s": 3600, "lasting_s": [0.1, 2], "kinds": ["halt",
//    "late"]}}
//
// Times are seconds after the chain's start. A fault without "from_s" begins there, one without "to_s" lasts
// to the end of the run. A kind takes only the keys that say something of it.

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "framework/usecase/use_case.h"

namespace svchain {

enum class FaultKind : uint8_t {
  // Of what a source (a camera) gives on one of its outputs:
  kDropout,         // nothing comes
  kFreeze,          // the same picture again and again, with new times
  kJitter,          // time stamps are off at random, by at most "jitter_ms"
  kWrongTimestamp,  // time stamps are off by "shift_ms"
  kCorrupt,         // the lower rows of the picture are noise
  // Of a link:
  kSlow,      // its calls take "factor" times as long, and "extra_ms" more
  kThrow,     // its calls throw
  kNoMemory,  // its pools have no free buffer
  // Of an edge:
  kLost,  // messages do not arrive
  kLate,  // messages leave "late_ms" later, in their order
  kFull,  // has no room
  // Of a core: it stands still, then starts again: what its links were given as a state has to come again.
  kHalt,
  // Of all: the clock that links see steps by "step_ms", and back at the end.
  kClockStep,
};
inline constexpr std::array<const char*, 13> kFaultKindNames = {
    "dropout", "freeze", "jitter", "wrong_timestamp", "corrupt", "slow", "throw", "no_memory", "lost",
    "late",    "full",   "halt",   "clock_step"};
inline constexpr size_t kFaultKinds = kFaultKindNames.size();
inline const char* name_of(FaultKind kind) {
  return kFaultKindNames[static_cast<size_t>(kind)];
}

struct FaultEntry {
  FaultKind kind = FaultKind::kDropout;
  /// LINK, LINK.OUTPUT, "LINK.OUTPUT -> LINK.INPUT" or a core, as the kind has it; none for the clock.
  std::string at;
  double from_s = 0, to_s = std::numeric_limits<double>::infinity();
  /// Of every frame, message or call. A state has none: freeze, slow, no_memory, full, halt, clock_step.
  double chance = 1;
  double amount_ms = 0;  // "jitter_ms", "shift_ms", "extra_ms", "late_ms" or "step_ms"
  double factor = 1;     // of kSlow
  Origin origin;
};

/// Faults drawn by a seed: so many an hour, each of a kind, at a place and for a time that chance picks.
struct RandomFaults {
  double per_hour = 0;
  double from_s = 0, to_s = 0;  // none begins before, and none lasts beyond
  std::array<double, 2> lasting_s = {0.05, 2};
  std::vector<FaultKind> kinds;  // all, where the file says none
  Origin origin;
};

struct FaultScript {
  std::string file;
  std::vector<FaultEntry> entries;  // in the file's order
  std::optional<RandomFaults> random;
};

/// All faults of the file at once.
Result<FaultScript> read_fault_script(const std::filesystem::path& path);
Result<FaultScript> parse_fault_script(const std::string& text, const std::string& file);

}  // namespace svchain
