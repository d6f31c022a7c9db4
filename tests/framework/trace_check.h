#pragma once
// What has to be true of every trace, whatever was run.

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "framework/chain/chain.h"
#include "framework/trace/chrome_trace.h"
#include "tests/catch.h"

namespace svchain::testing {

/// Reads a trace from its beginning to its end, as a viewer does: a slice belongs to the thread's latest "X",
/// an arrow to the slice that its thread had last.
class TraceCheck {
 public:
  struct Slice {
    std::string link;
    int64_t begin_ns = 0, end_ns = 0;
  };

  explicit TraceCheck(const Chain& chain) : TraceCheck(chain.plan(), chrome_trace(chain.traced())) {}
  TraceCheck(const Plan& plan, const std::string& text) : plan_(plan), trace(nlohmann::json::parse(text)) {
    for (const auto& event : trace["traceEvents"]) {
      const std::string phase = event["ph"];
      if (phase == "M") continue;
      const int64_t at_ns = ns(event["ts"]);
      in_time_ = in_time_ && at_ns >= last_ns_;
      last_ns_ = at_ns;
      if (phase == "X") slice(event, at_ns);
      if (phase == "s") begin_arrow(event, at_ns);
      if (phase == "f") end_arrow(event, at_ns);
      if (phase == "C") counter(event);
      if (phase == "i") drops[event["name"]] += event["args"]["count"].get<uint64_t>();
    }
    CHECK(in_time_);
    CHECK(slices_in_turn_);
    CHECK(arrows_bound_);
    CHECK(between_cores_);
    CHECK(open_.empty());
    CHECK(within_capacity_);
  }

  /// How often a link was called, by its slices.
  uint64_t calls(const std::string& link) const {
    const auto found = calls_.find(link);
    return found == calls_.end() ? 0 : found->second;
  }
  /// What waits on an edge in the end.
  int waiting(const std::string& edge) const {
    const auto found = waiting_.find(edge);
    return found == waiting_.end() ? 0 : found->second;
  }

 private:
  static int64_t ns(const nlohmann::json& us) { return std::llround(us.get<double>() * 1000); }

  void slice(const nlohmann::json& event, int64_t at_ns) {
    Slice& last = last_[event["tid"]];
    const int64_t end_ns = at_ns + ns(event["dur"]);
    slices_in_turn_ = slices_in_turn_ && end_ns >= at_ns && at_ns >= last.end_ns;
    last = {event["name"], at_ns, end_ns};
    if (event["cat"] == "call") ++calls_[last.link];
  }

  /// The link at the beginning or the end of "a.out -> b.in".
  bool bound(const nlohmann::json& event, int64_t at_ns, bool begins) {
    const std::string edge = event["name"];
    const std::string port = begins ? edge : edge.substr(edge.find("-> ") + 3);
    const Slice& last = last_[event["tid"]];
    return last.link == port.substr(0, port.find('.')) && at_ns >= last.begin_ns && at_ns <= last.end_ns;
  }
  void begin_arrow(const nlohmann::json& event, int64_t at_ns) {
    arrows_bound_ = arrows_bound_ && bound(event, at_ns, true);
    between_cores_ = between_cores_ && ids_.insert(event["id"].get<uint64_t>()).second;
    open_[event["id"]] = event["tid"];
  }
  void end_arrow(const nlohmann::json& event, int64_t at_ns) {
    arrows_bound_ = arrows_bound_ && bound(event, at_ns, false) && event["bp"] == "e";
    const auto open = open_.find(event["id"]);
    between_cores_ = between_cores_ && open != open_.end() && open->second != event["tid"];
    if (open != open_.end()) open_.erase(open);
    ++arrows[event["name"]];
  }
  void counter(const nlohmann::json& event) {
    const int value = event["args"]["waiting"];
    waiting_[event["name"]] = value;
    for (const PlannedEdge& edge : plan_.edges) {
      if (edge.entry.name() != event["name"]) continue;
      const bool in_hand =
          edge.ipc && (edge.entry.policy == Policy::kLatest || edge.entry.policy == Policy::kDropOldest);
      within_capacity_ = within_capacity_ && value >= 0 && value <= edge.entry.depth + (in_hand ? 1 : 0);
    }
  }

  const Plan& plan_;

 public:
  nlohmann::json trace;
  std::map<std::string, uint64_t> drops;   // by reason
  std::map<std::string, uint64_t> arrows;  // by edge

 private:
  std::map<int, Slice> last_;  // by thread
  std::map<std::string, uint64_t> calls_;
  std::map<std::string, int> waiting_;
  std::map<uint64_t, int> open_;  // threads of arrows on their way, by id
  std::set<uint64_t> ids_;
  int64_t last_ns_ = 0;
  bool in_time_ = true, slices_in_turn_ = true, arrows_bound_ = true, between_cores_ = true,
       within_capacity_ = true;
};

/// And where every link's calls were recorded and none threw.
inline void check_calls(const TraceCheck& check, const Chain& chain) {
  const auto report = chain.report();
  for (const auto& [name, link] : report["links"].items()) {
    INFO(name);
    CHECK(check.calls(name) == link["processed"].get<uint64_t>());
  }
  for (const auto& [name, edge] : report["edges"].items()) {
    INFO(name);
    CHECK(check.waiting(name) == 0);
  }
}

}  // namespace svchain::testing
