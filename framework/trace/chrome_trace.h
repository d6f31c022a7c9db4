#pragma once
// The file of a traced run: Chrome's trace event format, which Perfetto opens. A thread for every core, in
// the SoC's order; a slice ("X") for every call of a link, with its frame; flow arrows ("s", "f") for frames
// that went from core to core, from call to call; a counter ("C") of what waits on every edge; instant events
// ("i") for drops, named by their reason. Times in microseconds by the chain's clock. What the file says
// follows from what was recorded alone: a virtual run gives the same bytes every time.
//
// Format: "Trace Event Format", the Chromium project. It wants a process: here it is always 1.

#include <string>

#include "framework/trace/traced_run.h"

namespace svchain {

std::string chrome_trace(const TracedRun& run);

}  // namespace svchain
