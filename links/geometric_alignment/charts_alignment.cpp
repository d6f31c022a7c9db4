#include "links/geometric_alignment/charts_alignment.h"

#include "algorithms/calibration/calibration.h"
#include "algorithms/calibration/calibration_json.h"
#include "algorithms/calibration/content_start.h"
#include "algorithms/calibration/scene_charts.h"
#include "links/configs_folder.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

Result<std::vector<calibration::Chart>> named_charts(const std::string& named) {
  const auto file = find_config("charts", "charts", named);
  if (!file) return tl::unexpected(file.error());
  return calibration::read_charts(*file);
}

/// None where frames come from elsewhere.
Result<std::vector<calibration::Chart>> simulated_charts(const Configuration& configuration) {
  const auto scene = simulated_scene(configuration);
  if (!scene) return tl::unexpected(scene.error());
  if (!*scene) return {};
  return calibration::charts_of(**scene);
}

nlohmann::json accuracy_json(const calibration::Calibration& found, bool with_times) {
  auto json = nlohmann::json::parse(calibration::rig_part(found, ""));
  json.erase("date");
  if (!with_times) return json;
  for (const auto& [stage, ms] : found.stage_ms) json["stages_ms"][stage] = ms;
  return json;
}

std::vector<std::string> reasons_of(const calibration::Calibration& found) {
  std::vector<std::string> reasons = found.reasons;
  for (size_t i = 0; i < found.cameras.size(); ++i) {
    for (const std::string& reason : found.cameras[i].reasons)
      reasons.push_back(found.rig.cameras[i].name + ": " + reason);
  }
  return reasons;
}

}  // namespace

std::vector<calibration::Chart> charts_in_use(Configuration& configuration, const std::string& named) {
  const auto charts = named.empty() ? simulated_charts(configuration) : named_charts(named);
  if (!charts) {
    configuration.faults(charts.error());
    return {};
  }
  if (charts->empty()) {
    configuration.parameter_fault("charts", "missing: nothing says what charts lie on the ground of \"" +
                                                configuration.setting("input").text("value") + "\"");
  }
  return *charts;
}

GroundAlignment align_by_charts(const AlignmentSettings& settings, const std::array<cv::Mat, 4>& pictures,
                                bool with_times) {
  calibration::CalibrationInput input;
  input.nominal = settings.rig;
  input.charts = settings.charts;
  input.pictures.assign(pictures.begin(), pictures.end());
  if (settings.from_content) calibration::start_from_content(input);
  const calibration::Calibration found = calibration::calibrate(input);
  return {found.rig, synthesis::rays_from_ground(found.rig), reasons_of(found),
          accuracy_json(found, with_times)};
}

}  // namespace svchain
