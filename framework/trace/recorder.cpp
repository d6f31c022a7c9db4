#include "framework/trace/recorder.h"

namespace svchain {

Recorder::Recorder(size_t capacity)
    : region_("svchain:trace", capacity * sizeof(TraceEvent)),
      events_(reinterpret_cast<TraceEvent*>(region_.bytes().data())),
      capacity_(capacity) {}

void Recorder::end_run(int64_t end_ns) {
  for (; run_ < count_; ++run_) {
    if (events_[run_].time_ns == kAtEnd) events_[run_].time_ns = end_ns;
  }
}

}  // namespace svchain
