#include "usecases/svchain/trace_file.h"

#include <algorithm>
#include <map>

#include "algorithms/json/value.h"

namespace svchain::program {

namespace {

constexpr json::Range kTimes = {0, 1e15, "us"};
constexpr json::Range kWhole = {0, 9e15};

class Reader {
 public:
  Reader(const json::Document& document, Faults& faults) : root_(document, faults) {}

  TraceFile read() {
    read_about(root_.optional("otherData"));
    const json::Value list = root_.required("traceEvents");
    const std::vector<json::Value> events = list.items();
    for (const json::Value& event : events) read_name(event);
    order_tracks();
    const size_t faults_before = root_.fault_count();
    for (const json::Value& event : events) read_event(event);
    for (const auto& [id, open] : open_arrows_)
      open.at.fault("this arrow never ends: expected an \"f\" of its id");
    if (trace_.slices.empty() && root_.fault_count() == faults_before)
      list.fault("no slice (\"ph\": \"X\") in it: there is nothing to draw");
    return std::move(trace_);
  }

 private:
  struct OpenArrow {
    TraceMoment from;
    json::Value at;
  };
  struct Track {
    std::string name;
    long long sort_index = 0;
  };

  void read_about(const json::Value& about) {
    if (!about) return;
    trace_.use_case = about.optional("usecase").string();
    trace_.soc = about.optional("soc").string();
    trace_.modelled = about.optional("modelled").boolean();
    trace_.lost_events = about.optional("lost_events").integer(kWhole);
    for (const json::Value& link : about.optional("links").items()) add_link(link.string());
    for (const json::Value& link : about.optional("delivering").items()) {
      trace_.delivering.push_back(link.string());
    }
  }

  void add_link(const std::string& link) {
    auto& links = trace_.links;
    if (std::find(links.begin(), links.end(), link) == links.end()) links.push_back(link);
  }

  static std::string phase_of(const json::Value& event) { return event.required("ph").string(); }

  void read_name(const json::Value& event) {
    if (phase_of(event) != "M") return;
    const std::string name = event.required("name").string();
    if (name != "thread_name" && name != "thread_sort_index") return;
    Track& track = tracks_[event.required("tid").integer(kWhole)];
    const json::Value arguments = event.required("args");
    if (name == "thread_name") track.name = arguments.required("name").string();
    if (name == "thread_sort_index") track.sort_index = arguments.required("sort_index").integer();
  }

  void order_tracks() {
    std::vector<std::pair<long long, Track>> ordered(tracks_.begin(), tracks_.end());
    std::erase_if(ordered, [](const auto& entry) { return entry.second.name.empty(); });
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const auto& a, const auto& b) { return a.second.sort_index < b.second.sort_index; });
    for (const auto& [id, track] : ordered) {
      places_[id] = trace_.tracks.size();
      trace_.tracks.push_back(track.name);
    }
  }

  void read_event(const json::Value& event) {
    const json::Value phase = event.optional("ph");
    if (!phase || !phase.is_string()) return;  // said by read_name()
    const std::string kind = phase.string();
    if (kind == "X") read_slice(event);
    if (kind == "s" || kind == "f") read_arrow(event, kind == "s");
    if (kind == "i" && event.optional("cat").string() == "drop")
      trace_.drops.push_back({event.required("name").string(), read_moment(event)});
  }

  TraceMoment read_moment(const json::Value& event) {
    TraceMoment moment;
    moment.at_ms = event.required("ts").number(kTimes) * 1e-3;
    const json::Value id = event.required("tid");
    const size_t faults_before = root_.fault_count();
    const auto place = places_.find(id.integer(kWhole));
    if (place != places_.end()) {
      moment.track = place->second;
    } else if (root_.fault_count() == faults_before) {
      id.fault("no \"thread_name\" event names this track");
    }
    return moment;
  }

  void read_slice(const json::Value& event) {
    TraceSlice slice;
    slice.link = event.required("name").string();
    const TraceMoment begin = read_moment(event);
    slice.track = begin.track;
    slice.begin_ms = begin.at_ms;
    slice.end_ms = begin.at_ms + event.required("dur").number(kTimes) * 1e-3;
    if (const json::Value arguments = event.optional("args")) {
      if (const json::Value frame = arguments.optional("frame")) slice.frame = frame.integer(kWhole);
    }
    add_link(slice.link);
    trace_.slices.push_back(std::move(slice));
  }

  void read_arrow(const json::Value& event, bool begins) {
    const size_t faults_before = root_.fault_count();
    const json::Value id = event.required("id");
    const long long number = id.integer(kWhole);
    const std::string edge = event.required("name").string();
    const TraceMoment moment = read_moment(event);
    if (root_.fault_count() > faults_before) return;
    const auto open = open_arrows_.find(number);
    if (begins) {
      if (open != open_arrows_.end()) return id.fault("another arrow of this id has not ended yet");
      open_arrows_.insert({number, {moment, event}});
    } else {
      if (open == open_arrows_.end())
        return id.fault("this arrow has no beginning: expected an \"s\" of its id");
      trace_.arrows.push_back({edge, open->second.from, moment});
      open_arrows_.erase(open);
    }
  }

  json::Value root_;
  TraceFile trace_;
  std::map<long long, Track> tracks_;   // by thread id
  std::map<long long, size_t> places_;  // of a thread id among the tracks
  std::map<long long, OpenArrow> open_arrows_;
};

}  // namespace

double TraceFile::begin_ms() const {
  return std::min_element(slices.begin(), slices.end(),
                          [](const TraceSlice& a, const TraceSlice& b) { return a.begin_ms < b.begin_ms; })
      ->begin_ms;
}

double TraceFile::end_ms() const {
  return std::max_element(slices.begin(), slices.end(),
                          [](const TraceSlice& a, const TraceSlice& b) { return a.end_ms < b.end_ms; })
      ->end_ms;
}

Result<TraceFile> read_trace(const std::filesystem::path& path) {
  const auto document = json::Document::read(path);
  if (!document) return tl::unexpected(document.error());
  Faults faults;
  TraceFile trace = Reader(*document, faults).read();
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return trace;
}

}  // namespace svchain::program
