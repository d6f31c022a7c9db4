#pragma once
// What a timeline needs of a trace file (framework/trace/chrome_trace.h): slices, arrows and drops on named
// tracks. Other programs' files of that format serve as far as they have these; all other events are passed
// over. Times in milliseconds. Plain values, any thread.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/json/fault.h"

namespace svchain::program {

struct TraceSlice {
  std::string link;
  size_t track = 0;
  double begin_ms = 0, end_ms = 0;
  std::optional<long long> frame;
};

struct TraceMoment {
  size_t track = 0;
  double at_ms = 0;
};

struct TraceArrow {
  std::string edge;
  TraceMoment from, to;
};

struct TraceDrop {
  std::string reason;
  TraceMoment where;
};

struct TraceFile {
  std::string use_case, soc;  // empty where the file does not say
  bool modelled = false;
  long long lost_events = 0;
  std::vector<std::string> delivering;
  std::vector<std::string> tracks;  // from top to bottom
  std::vector<std::string> links;   // as the file lists them, others by their first slices
  std::vector<TraceSlice> slices;   // in the file's order
  std::vector<TraceArrow> arrows;
  std::vector<TraceDrop> drops;

  double begin_ms() const;
  double end_ms() const;
};

/// All faults at once. A file without a single slice is one.
Result<TraceFile> read_trace(const std::filesystem::path& path);

}  // namespace svchain::program
