#pragma once
// Draws a part of a trace: a lane for every core, link calls as boxes in their links' colours with the
// numbers of their frames, arrows where frames go from core to core, drops as red marks, an axis in
// milliseconds and a legend. Any thread.

#include <string>

#include "usecases/svchain/trace_file.h"

namespace svchain::program {

struct TimePart {
  double from_ms = 0, to_ms = 0;
  std::string why;  // how it was picked, for the reader; may be empty
};

/// `part` is not empty, and the trace has slices.
std::string timeline_svg(const TraceFile& trace, const TimePart& part);

}  // namespace svchain::program
