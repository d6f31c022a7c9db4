#pragma once
// What happens on one core of a traced chain, as it happens: link calls, messages that leave and that are
// taken, drops. A block of events of fixed size that is there before the chain starts; memory that stays
// unused is never touched. When it is full, what follows is only counted.
//
// Thread rule: written by the core's thread alone, without a lock or an allocation; read once that has ended.
// Times in nanoseconds by the chain's clock, which is never read for this.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "ipc/shared_region.h"

namespace svchain {

struct TraceEvent {
  enum class Kind : uint8_t {
    kCall,      // of a link's process(), from time_ns to end_ns
    kFinish,    // of its finish()
    kSent,      // on an edge; it leaves at time_ns
    kTaken,     // from an edge
    kReceived,  // never recorded: made of kTaken for the call that was given the frame
    kLinkDrop,  // by a link
    kEdgeDrop,  // by an edge
  };
  int64_t time_ns;
  union {
    int64_t end_ns;      // of calls
    const char* reason;  // of drops, a literal
  };
  uint64_t number;  // of calls: their frame; of messages: which one of the edge, from 1; of drops: how many
  int32_t subject;  // the link or the edge
  uint16_t taken_back;  // messages of the edge that had to make room for this one
  Kind kind;
  bool is_frame;  // of messages: no absence
};
static_assert(sizeof(TraceEvent) == 32);

/// Events of a whole chain where nothing else is said: 32 MB, some minutes of surround view.
constexpr size_t kUsualTraceEvents = size_t{1} << 20;

class Recorder {
 public:
  /// The time of what leaves when the run of the link ends.
  static constexpr int64_t kAtEnd = std::numeric_limits<int64_t>::max();

  /// Throws std::system_error where there is no memory for so many events, at least one.
  explicit Recorder(size_t capacity);

  void sent(int edge, uint64_t number, bool is_frame, size_t taken_back, int64_t time_ns) {
    if (TraceEvent* event = next(TraceEvent::Kind::kSent, time_ns, edge, number)) {
      event->is_frame = is_frame;
      event->taken_back = static_cast<uint16_t>(taken_back);
    }
  }
  void taken(int edge, uint64_t number, bool is_frame, int64_t time_ns) {
    if (TraceEvent* event = next(TraceEvent::Kind::kTaken, time_ns, edge, number)) event->is_frame = is_frame;
  }
  void link_dropped(int link, const char* reason, uint64_t count) {
    if (TraceEvent* event = next(TraceEvent::Kind::kLinkDrop, kAtEnd, link, count)) event->reason = reason;
  }
  void edge_dropped(int edge, const char* reason) {
    if (TraceEvent* event = next(TraceEvent::Kind::kEdgeDrop, kAtEnd, edge, 1)) event->reason = reason;
  }
  /// A call (or a finish) of a link that has just ended.
  void called(TraceEvent::Kind kind, int link, uint64_t frame, int64_t begin_ns, int64_t end_ns) {
    if (TraceEvent* event = next(kind, begin_ns, link, frame)) event->end_ns = end_ns;
  }
  /// Ends a run of a link, whether it has been called or not: what it has sent and dropped is of this time.
  void end_run(int64_t end_ns);

  std::span<const TraceEvent> events() const { return {events_, count_}; }
  uint64_t lost() const { return lost_; }

 private:
  /// The next place, filled as far as all events have it; null, and counted, if there is none.
  TraceEvent* next(TraceEvent::Kind kind, int64_t time_ns, int subject, uint64_t number) {
    if (count_ == capacity_) {
      ++lost_;
      return nullptr;
    }
    TraceEvent& event = events_[count_++];
    event.time_ns = time_ns;
    event.end_ns = 0;
    event.number = number;
    event.subject = subject;
    event.taken_back = 0;
    event.kind = kind;
    event.is_frame = false;
    return &event;
  }

  ipc::SharedRegion region_;  // for its huge pages: small ones would cost as much as the recording
  TraceEvent* events_;        // in the region
  size_t capacity_;
  size_t count_ = 0;
  size_t run_ = 0;  // the first event of the run that goes on
  uint64_t lost_ = 0;
};

}  // namespace svchain
