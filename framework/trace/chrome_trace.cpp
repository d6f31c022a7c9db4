#include "framework/trace/chrome_trace.h"

#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "framework/trace/event_order.h"

namespace svchain {

namespace {

using Kind = TraceEvent::Kind;

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump();
}

std::vector<std::string> all_quoted(const std::vector<std::string>& texts) {
  std::vector<std::string> list;
  list.reserve(texts.size());
  for (const std::string& text : texts) list.push_back(quoted(text));
  return list;
}

class ChromeTrace {
 public:
  explicit ChromeTrace(const TracedRun& run) : run_(run), links_(all_quoted(run.links)) {
    for (const TracedEdge& edge : run.edges) edges_.push_back(quoted(edge.name));
    waiting_.resize(run.edges.size());
  }

  std::string text() {
    const std::vector<OrderedEvent> events = in_order(run_);
    number_arrows(events);
    out_.reserve(4096 + events.size() * 128);
    head();
    names();
    for (const OrderedEvent& event : events) add(event);
    out_ += "\n]}\n";
    return std::move(out_);
  }

 private:
  void head() {
    uint64_t lost = 0;
    for (const Recorder* recorder : run_.recorders) lost += recorder->lost();
    const nlohmann::json about = {{"usecase", run_.use_case},      {"soc", run_.soc},
                                  {"modelled", run_.modelled},     {"links", run_.links},
                                  {"delivering", run_.delivering}, {"lost_events", lost}};
    out_ += "{\"displayTimeUnit\":\"ms\",\n\"otherData\":" + about.dump() + ",\n\"traceEvents\":[";
  }

  void names() {
    begin("process_name", "M");
    out_ += ",\"args\":{\"name\":" + quoted(run_.use_case + " on " + run_.soc) + "}}";
    for (size_t core = 0; core < run_.cores.size(); ++core) {
      begin("thread_name", "M", static_cast<int>(core));
      out_ += ",\"args\":{\"name\":" + quoted(run_.cores[core]) + "}}";
      begin("thread_sort_index", "M", static_cast<int>(core));
      out_ += ",\"args\":{\"sort_index\":" + std::to_string(core) + "}}";
    }
  }

  /// Messages of different edges have different numbers.
  void number_arrows(const std::vector<OrderedEvent>& events) {
    std::vector<uint64_t> most(run_.edges.size());
    for (const OrderedEvent& e : events) {
      if (e.event.kind == Kind::kSent) most[static_cast<size_t>(e.event.subject)] = e.event.number;
    }
    uint64_t next = 0;
    for (const uint64_t count : most) {
      first_arrow_.push_back(next);
      next += count;
    }
  }

  void add(const OrderedEvent& e) {
    switch (e.event.kind) {
      case Kind::kCall:
      case Kind::kFinish:
        return slice(e);
      case Kind::kSent:
        if (e.event.is_frame) arrow(e, "s", "");
        return counter(e);
      case Kind::kTaken:
        return counter(e);
      case Kind::kReceived:
        return arrow(e, "f", ",\"bp\":\"e\"");
      case Kind::kLinkDrop:
        return drop(e, "link", links_);
      case Kind::kEdgeDrop:
        return drop(e, "edge", edges_);
    }
  }

  void slice(const OrderedEvent& e) {
    begin_quoted(links_[static_cast<size_t>(e.event.subject)], "X", e.core);
    time("ts", e.event.time_ns);
    time("dur", e.event.end_ns - e.event.time_ns);
    if (e.event.kind == Kind::kFinish) {
      out_ += ",\"cat\":\"finish\"}";
    } else {
      out_ += ",\"cat\":\"call\",\"args\":{\"frame\":" + std::to_string(e.event.number) + "}}";
    }
  }

  void arrow(const OrderedEvent& e, const char* phase, const char* binding) {
    const auto edge = static_cast<size_t>(e.event.subject);
    begin_quoted(edges_[edge], phase, e.core);
    time("ts", e.event.time_ns);
    out_ += ",\"cat\":\"frame\",\"id\":" + std::to_string(first_arrow_[edge] + e.event.number);
    out_ += binding;
    out_ += "}";
  }

  void counter(const OrderedEvent& e) {
    const auto edge = static_cast<size_t>(e.event.subject);
    if (std::exchange(waiting_[edge], e.waiting) == e.waiting) return;
    begin_quoted(edges_[edge], "C");
    time("ts", e.event.time_ns);
    out_ += ",\"args\":{\"waiting\":" + std::to_string(e.waiting) + "}}";
  }

  void drop(const OrderedEvent& e, const char* whose, const std::vector<std::string>& names) {
    begin_quoted(quoted(e.event.reason), "i", e.core);
    time("ts", e.event.time_ns);
    out_ += ",\"cat\":\"drop\",\"s\":\"t\",\"args\":{\"" + std::string(whose) +
            "\":" + names[static_cast<size_t>(e.event.subject)] +
            ",\"count\":" + std::to_string(e.event.number) + "}}";
  }

  void begin(const char* name, const char* phase, int core = -1) {
    begin_quoted("\"" + std::string(name) + "\"", phase, core);
  }
  void begin_quoted(const std::string& name, const char* phase, int core = -1) {
    out_ += first_ ? "\n{\"name\":" : ",\n{\"name\":";
    first_ = false;
    out_ += name;
    out_ += ",\"ph\":\"";
    out_ += phase;
    out_ += "\",\"pid\":1";
    if (core >= 0) out_ += ",\"tid\":" + std::to_string(core + 1);
  }
  /// Nanoseconds as microseconds with three decimals.
  void time(const char* key, int64_t ns) {
    char text[48];
    std::snprintf(text, sizeof text, ",\"%s\":%" PRId64 ".%03d", key, ns / 1000, static_cast<int>(ns % 1000));
    out_ += text;
  }

  const TracedRun& run_;
  std::vector<std::string> links_, edges_;  // in quotes
  std::vector<int> waiting_;                // by edge, as written last
  std::vector<uint64_t> first_arrow_;       // by edge
  bool first_ = true;
  std::string out_;
};

}  // namespace

std::string chrome_trace(const TracedRun& run) {
  return ChromeTrace(run).text();
}

}  // namespace svchain
