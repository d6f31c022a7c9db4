#include "algorithms/bowl/path_json.h"

#include <utility>

#include "algorithms/bowl/viewpoint_presets.h"
#include "algorithms/json/value.h"

namespace svchain::bowl {
namespace {

using json::Value;

const json::Range kPlaceM{-1e4, 1e4, "m"};
const json::Range kTimeS{0, 1e6, "s"};

struct Reader {
  const geometry::Vehicle& vehicle;
  const BowlSurface& surface;

  Viewpoint preset_viewpoint(const Value& frame) const {
    frame.only({"time_s", "preset"});
    const std::string name = frame.required("preset").choice(preset_names(), "top");
    return *preset(name, vehicle, surface);
  }

  static Eigen::Vector3d vector(const Value& value, const json::Range& range,
                                const Eigen::Vector3d& fallback) {
    if (!value) return fallback;
    const auto numbers = value.numbers(3, range);
    return {numbers[0], numbers[1], numbers[2]};
  }

  Viewpoint free_viewpoint(const Value& frame) const {
    frame.only({"time_s", "preset", "eye_m", "target_m", "up", "field_of_view_deg"});
    if (frame.is_object() && !frame.optional("eye_m") && !frame.optional("target_m")) {
      frame.fault("expected \"preset\", or \"eye_m\" and \"target_m\"");
      return {};
    }
    const size_t before = frame.fault_count();
    Viewpoint viewpoint;
    viewpoint.eye_m = vector(frame.required("eye_m"), kPlaceM, viewpoint.eye_m);
    viewpoint.target_m = vector(frame.required("target_m"), kPlaceM, viewpoint.target_m);
    viewpoint.up = vector(frame.optional("up"), {}, viewpoint.up);
    viewpoint.field_of_view_deg = frame.optional("field_of_view_deg").number({}, viewpoint.field_of_view_deg);
    if (frame.fault_count() > before) return viewpoint;
    for (const Fault& fault : check(viewpoint, vehicle, surface)) {
      const Value culprit = frame.optional(fault.pointer.substr(1));
      (culprit ? culprit : frame).fault(fault.message);
    }
    return viewpoint;
  }

  std::vector<KeyFrame> key_frames(const Value& list) const {
    std::vector<KeyFrame> frames;
    for (const Value& item : list.items()) {
      KeyFrame frame;
      const Value time = item.required("time_s");
      frame.time_s = time.number(kTimeS);
      if (time.is_number() && !frames.empty() && !(frame.time_s > frames.back().time_s))
        time.fault("expected more than the " + std::to_string(frames.back().time_s) + " s before");
      frame.viewpoint = item.optional("preset") ? preset_viewpoint(item) : free_viewpoint(item);
      frames.push_back(frame);
    }
    if (list.is_array() && frames.empty()) list.fault("expected at least one key frame");
    return frames;
  }
};

}  // namespace

Result<ViewpointPath> parse_path(const std::string& text, const std::string& file,
                                 const geometry::Vehicle& vehicle, const BowlSurface& surface) {
  auto document = json::Document::parse(text, file);
  if (!document) return tl::unexpected(std::move(document.error()));
  Faults faults;
  const Value root(*document, faults);
  root.only({"loop", "key_frames"});
  const bool loop = root.optional("loop").boolean();
  const Value list = root.required("key_frames");
  const std::vector<KeyFrame> frames = Reader{vehicle, surface}.key_frames(list);
  if (loop && !frames.empty() &&
      (frames.size() < 2 || !(frames.front().viewpoint == frames.back().viewpoint)))
    root.optional("loop").fault("expected a last key frame that is the first again, where the loop closes");
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return ViewpointPath(frames, loop);
}

Result<ViewpointPath> read_path(const std::filesystem::path& path, const geometry::Vehicle& vehicle,
                                const BowlSurface& surface) {
  auto text = json::read_text(path);
  if (!text) return tl::unexpected(std::move(text.error()));
  return parse_path(*text, path.string(), vehicle, surface);
}

}  // namespace svchain::bowl
