#include <algorithm>
#include <iostream>

#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/run_numbers.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/timeline_svg.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

constexpr size_t kFramesShown = 6;

/// When frames were delivered; where nothing delivers, the ends of the calls of the first link.
std::vector<double> deliveries_ms(const TraceFile& trace) {
  const auto ends_of = [&](const std::vector<std::string>& links) {
    std::vector<double> ends;
    for (const TraceSlice& slice : trace.slices) {
      if (slice.frame && std::find(links.begin(), links.end(), slice.link) != links.end())
        ends.push_back(slice.end_ms);
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  };
  const auto delivered = ends_of(trace.delivering);
  return delivered.empty() ? ends_of({trace.links.front()}) : delivered;
}

/// A long trace shows a few frames once it has come to deliver them.
TimePart usual_part(const TraceFile& trace) {
  const std::vector<double> deliveries = deliveries_ms(trace);
  if (deliveries.size() > kFramesShown + 1 && deliveries[kFramesShown] > deliveries.front()) {
    return {deliveries.front(), deliveries[kFramesShown],
            "the first " + std::to_string(kFramesShown) + " frames after the first delivered one"};
  }
  return {trace.begin_ms(), trace.end_ms(), ""};
}

}  // namespace

int timeline(const TimelineOptions& options) {
  Faults faults = check_writable(options.output, "--output");
  const auto from_ms = read_number("--from", options.from, {0, 1e12, "ms"}, faults);
  const auto to_ms = read_number("--to", options.to, {0, 1e12, "ms"}, faults);
  const auto trace = read_trace(options.trace);
  append(faults, faults_of(trace));
  if (!trace) return say(faults);

  TimePart part = usual_part(*trace);
  if (from_ms || to_ms) part = {from_ms.value_or(trace->begin_ms()), to_ms.value_or(trace->end_ms()), ""};
  if ((from_ms || to_ms) && part.from_ms >= part.to_ms) {
    faults.push_back({from_ms ? "--from" : "--to",
                      {},
                      {},
                      "expected a beginning before the end, got " + std::to_string(part.from_ms) + " to " +
                          std::to_string(part.to_ms) + " ms"});
  }
  if (!faults.empty()) return say(faults);
  if (part.from_ms >= part.to_ms) part.to_ms = part.from_ms + 1;  // all at one moment of a virtual clock
  write_whole(options.output, timeline_svg(*trace, part));
  return kDone;
}

}  // namespace svchain::program
