#pragma once
// The events of all cores in one order: by time, and where times are equal so that no message is taken before
// it was sent, nor sent before there was room for it; then by core, then as they were recorded. So the same
// recordings always give the same order, and the number of messages that wait on an edge can be told after
// every event.
//
// Before the events of a run comes its call, and after the call what it was given (kReceived). Messages
// between cores keep `is_frame` where an arrow can be drawn: both ends were recorded, and lie in calls.
// Where events were lost, what hangs on them is left out.

#include <vector>

#include "framework/trace/traced_run.h"

namespace svchain {

struct OrderedEvent {
  TraceEvent event;
  int core = 0;
  int waiting = 0;  // after kSent and kTaken: messages on the edge
};

std::vector<OrderedEvent> in_order(const TracedRun& run);

}  // namespace svchain
