#include "algorithms/calibration/clicked_corners.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "algorithms/calibration/calibration_json.h"
#include "algorithms/json/value.h"

namespace svchain::calibration {

namespace {

using json::Value;

// Bounds as in configs/schemas/corners.schema.json.
constexpr json::Range kCorner{0, 1e6};
constexpr json::Range kPixel{-0.5, 16384, "px"};

size_t index_of(const std::string& name, const std::vector<std::string>& names) {
  return static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

class Reader {
 public:
  Reader(const geometry::Rig& rig, const std::vector<Chart>& charts) : rig_(rig) {
    for (const auto& chart : charts) {
      chart_names_.push_back(chart.name);
      corner_counts_.push_back(corners(chart).size());
    }
  }

  void read(const Value& item) {
    item.only({"camera", "chart", "corner", "pixel_px", "state", "predicted_px"});
    const size_t before = item.fault_count();
    ClickedCorner corner;
    corner.camera = index_of(item.required("camera").choice(geometry::kCameraNames), geometry::kCameraNames);
    corner.chart = read_chart(item.required("chart"));
    corner.corner = static_cast<int>(item.required("corner").integer(kCorner));
    item.optional("predicted_px").numbers(2);
    if (item.optional("state").choice(corner_state_names()) == "not_found") return;
    const Value pixel = item.required("pixel_px");
    const auto place = pixel.numbers(2, kPixel);
    corner.pixel = {place[0], place[1]};
    if (item.fault_count() > before || chart_names_.empty()) return;
    check(item, corner);
    clicked_.push_back(corner);
  }

  std::vector<ClickedCorner> clicked() { return std::move(clicked_); }

 private:
  size_t read_chart(const Value& chart) const {
    const std::string name = chart.string();
    const size_t index = index_of(name, chart_names_);
    if (chart.is_string() && !chart_names_.empty() && index == chart_names_.size())
      chart.fault("no chart \"" + name + "\"" + did_you_mean(name, chart_names_) +
                  " (known: " + spoken_list(chart_names_) + ")");
    return index;
  }

  void check(const Value& item, const ClickedCorner& corner) {
    const std::string& chart = chart_names_[corner.chart];
    const size_t count = corner_counts_[corner.chart];
    if (corner.corner >= static_cast<int>(count))
      item.required("corner").fault("expected 0 to " + std::to_string(count - 1) +
                                    ", the corners of chart \"" + chart + "\", got " +
                                    std::to_string(corner.corner));
    if (!known_.insert({corner.camera, corner.chart, corner.corner}).second)
      item.fault("corner " + std::to_string(corner.corner) + " of chart \"" + chart + "\" is clicked in " +
                 geometry::kCameraNames[corner.camera] + "'s picture already, expected once");
    if (rig_.cameras.size() <= corner.camera) return;
    const auto& camera = rig_.cameras[corner.camera];
    if (!camera.contains(corner.pixel))
      item.required("pixel_px")
          .fault("lies outside the picture, expected one of " + std::to_string(camera.image_size_px.x()) +
                 "x" + std::to_string(camera.image_size_px.y()) + " px");
  }

  const geometry::Rig& rig_;
  std::vector<std::string> chart_names_;
  std::vector<size_t> corner_counts_;
  std::set<std::tuple<size_t, size_t, int>> known_;
  std::vector<ClickedCorner> clicked_;
};

}  // namespace

Result<std::vector<ClickedCorner>> parse_clicked_corners(const std::string& text, const std::string& file,
                                                         const geometry::Rig& rig,
                                                         const std::vector<Chart>& charts) {
  const auto document = json::Document::parse(text, file);
  if (!document) return tl::unexpected(document.error());
  Faults faults;
  const Value root(*document, faults);
  root.only(report_keys());
  const Value list = root.required("corners");
  Reader reader(rig, charts);
  for (const auto& item : list.items()) reader.read(item);
  if (list.is_array() && list.items().empty()) list.fault("expected at least one corner");
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return reader.clicked();
}

Result<std::vector<ClickedCorner>> read_clicked_corners(const std::filesystem::path& path,
                                                        const geometry::Rig& rig,
                                                        const std::vector<Chart>& charts) {
  const auto text = json::read_text(path);
  if (!text) return tl::unexpected(text.error());
  return parse_clicked_corners(*text, path.string(), rig, charts);
}

}  // namespace svchain::calibration
