#include "framework/trace/event_order.h"

#include <algorithm>
#include <span>
#include <utility>

namespace svchain {

namespace {

using Kind = TraceEvent::Kind;
using Events = std::vector<TraceEvent>;

bool is_call(Kind kind) {
  return kind == Kind::kCall || kind == Kind::kFinish;
}

bool is_drop(Kind kind) {
  return kind == Kind::kLinkDrop || kind == Kind::kEdgeDrop;
}

/// One core's events, each call before what belongs to it.
class CoreEvents {
 public:
  CoreEvents(const TracedRun& run, const Recorder& recorder)
      : run_(run), recorded_(recorder.events()), in_hand_(run.edges.size()) {
    list_.reserve(recorded_.size() + recorded_.size() / 4);
  }

  Events sorted() {
    size_t first = 0;
    for (size_t i = 0; i < recorded_.size(); ++i) {
      const TraceEvent& event = recorded_[i];
      if (event.kind == Kind::kTaken) in_hand_[static_cast<size_t>(event.subject)] = &event;
      if (!is_call(event.kind)) continue;
      list_.push_back(event);
      if (event.kind == Kind::kCall) receive(event);
      append(first, i, true);
      first = i + 1;
    }
    append(first, recorded_.size(), false);
    std::stable_sort(list_.begin(), list_.end(),
                     [](const TraceEvent& a, const TraceEvent& b) { return a.time_ns < b.time_ns; });
    return std::move(list_);
  }

 private:
  /// The newest frame from every other core that has come since the link's last call. It may have been sent
  /// after the clock was read for this call.
  void receive(const TraceEvent& call) {
    for (size_t e = 0; e < run_.edges.size(); ++e) {
      const TracedEdge& edge = run_.edges[e];
      if (edge.to_link != call.subject || !edge.crosses) continue;
      const TraceEvent* taken = std::exchange(in_hand_[e], nullptr);
      if (!taken || !taken->is_frame) continue;
      list_.push_back(*taken);
      list_.back().kind = Kind::kReceived;
      list_.back().time_ns = std::max(call.time_ns, taken->time_ns);
    }
  }

  /// Drops last: at the same time as messages they leave those to the call.
  void append(size_t first, size_t end, bool called) {
    for (const bool drops : {false, true}) {
      for (size_t i = first; i < end; ++i) {
        TraceEvent event = recorded_[i];
        if (is_drop(event.kind) != drops) continue;
        if (event.kind == Kind::kSent) {
          event.is_frame = event.is_frame && called && run_.edges[static_cast<size_t>(event.subject)].crosses;
        }
        list_.push_back(event);
      }
    }
  }

  const TracedRun& run_;
  std::span<const TraceEvent> recorded_;
  std::vector<const TraceEvent*> in_hand_;  // by edge: taken last, and not yet part of a call
  Events list_;
};

/// Numbers of an edge's messages, growing.
using Numbers = std::vector<uint64_t>;

std::vector<Numbers> numbers_of(const TracedRun& run, const std::vector<Events>& cores, Kind kind) {
  std::vector<Numbers> numbers(run.edges.size());
  for (const Events& events : cores) {
    for (const TraceEvent& event : events) {
      if (event.kind == kind && event.is_frame)
        numbers[static_cast<size_t>(event.subject)].push_back(event.number);
    }
  }
  for (Numbers& list : numbers) std::sort(list.begin(), list.end());
  return numbers;
}

/// Arrows have two ends.
void keep_whole_arrows(const TracedRun& run, std::vector<Events>& cores) {
  const auto sent = numbers_of(run, cores, Kind::kSent);
  const auto received = numbers_of(run, cores, Kind::kReceived);
  const auto lacks = [](const std::vector<Numbers>& numbers, const TraceEvent& event) {
    const Numbers& list = numbers[static_cast<size_t>(event.subject)];
    return !std::binary_search(list.begin(), list.end(), event.number);
  };
  for (Events& events : cores) {
    for (TraceEvent& event : events) {
      if (event.kind == Kind::kSent && lacks(received, event)) event.is_frame = false;
    }
    std::erase_if(
        events, [&](const TraceEvent& event) { return event.kind == Kind::kReceived && lacks(sent, event); });
  }
}

/// How far an edge has come.
struct Flow {
  int capacity = 0;
  uint64_t sent = 0;
  int waiting = 0;

  bool allows(const TraceEvent& event) const {
    if (event.kind == Kind::kTaken || event.kind == Kind::kReceived) return event.number <= sent;
    return event.kind != Kind::kSent || waiting - event.taken_back < capacity;
  }
  /// Within its bounds even where events were lost.
  void go_on(const TraceEvent& event) {
    if (event.kind == Kind::kSent) sent = event.number;
    if (event.kind == Kind::kSent) waiting += 1 - event.taken_back;
    if (event.kind == Kind::kTaken) --waiting;
    waiting = std::clamp(waiting, 0, capacity);
  }
};

bool is_of_edge(Kind kind) {
  return kind == Kind::kSent || kind == Kind::kTaken || kind == Kind::kReceived;
}

class Merge {
 public:
  Merge(const TracedRun& run, const std::vector<Events>& cores) : cores_(cores), next_(cores.size()) {
    for (const TracedEdge& edge : run.edges) flows_.push_back({edge.capacity});
  }

  std::vector<OrderedEvent> all() {
    std::vector<OrderedEvent> ordered;
    size_t count = 0;
    for (const Events& events : cores_) count += events.size();
    ordered.reserve(count);
    while (ordered.size() < count) {
      const size_t core = whose_turn();
      const TraceEvent& event = head(core);
      ++next_[core];
      ordered.push_back({event, static_cast<int>(core), 0});
      if (!is_of_edge(event.kind)) continue;
      Flow& flow = flows_[static_cast<size_t>(event.subject)];
      flow.go_on(event);
      ordered.back().waiting = flow.waiting;
    }
    return ordered;
  }

 private:
  const TraceEvent& head(size_t core) const { return cores_[core][next_[core]]; }

  /// The first core of those whose next event is the earliest and may happen now; where events were lost,
  /// perhaps none may.
  size_t whose_turn() const {
    size_t earliest = cores_.size(), allowed = cores_.size();
    for (size_t core = 0; core < cores_.size(); ++core) {
      if (next_[core] == cores_[core].size()) continue;
      const TraceEvent& event = head(core);
      if (earliest < cores_.size() && event.time_ns > head(earliest).time_ns) continue;
      if (earliest == cores_.size() || event.time_ns < head(earliest).time_ns) {
        earliest = core;
        allowed = cores_.size();
      }
      if (allowed == cores_.size() &&
          (!is_of_edge(event.kind) || flows_[static_cast<size_t>(event.subject)].allows(event)))
        allowed = core;
    }
    return allowed < cores_.size() ? allowed : earliest;
  }

  const std::vector<Events>& cores_;
  std::vector<size_t> next_;
  std::vector<Flow> flows_;
};

}  // namespace

std::vector<OrderedEvent> in_order(const TracedRun& run) {
  std::vector<Events> cores;
  for (const Recorder* recorder : run.recorders) cores.push_back(CoreEvents(run, *recorder).sorted());
  keep_whole_arrows(run, cores);
  return Merge(run, cores).all();
}

}  // namespace svchain
