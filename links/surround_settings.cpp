#include "links/surround_settings.h"

#include "algorithms/scene/nominal_rig.h"
#include "algorithms/scene/scene_file.h"
#include "links/capture/simulated_source.h"

namespace svchain {

namespace {

/// The rig of that file, or what the simulated scene gives instead.
template <class FromScene>
Result<geometry::Rig> rig_or(const std::string& rig, const std::string& input, FromScene from_scene) {
  if (!rig.empty()) return geometry::read_rig(rig);
  const auto scene = simulated_scene(input);
  if (!scene) return tl::unexpected(scene.error());
  if (*scene) return from_scene(**scene);
  return fail("--rig",
              "missing: frames from \"" + input + "\" need a rig file that says how the cameras look");
}

std::string plain_setting(const Configuration& configuration, const std::string& name) {
  return configuration.setting(name).text("value");
}

}  // namespace

Result<geometry::Rig> rig_in_use(const Configuration& configuration) {
  return rig_or(plain_setting(configuration, "rig"), plain_setting(configuration, "input"),
                [](const scene::Scene& scene) { return scene.rig; });
}

Result<geometry::Rig> nominal_rig_in_use(const Configuration& configuration) {
  return nominal_rig_of(plain_setting(configuration, "rig"), plain_setting(configuration, "input"));
}

Result<geometry::Rig> nominal_rig_of(const std::string& rig, const std::string& input) {
  return rig_or(rig, input, scene::nominal_rig);
}

Result<std::optional<scene::Scene>> simulated_scene(const Configuration& configuration) {
  return simulated_scene(plain_setting(configuration, "input"));
}

Result<std::optional<scene::Scene>> simulated_scene(const std::string& input) {
  constexpr std::string_view kSimulated = "simulated:";
  if (!input.starts_with(kSimulated)) return std::nullopt;
  const auto file = find_scene(input.substr(kSimulated.size()));
  if (!file) return tl::unexpected(file.error());
  auto scene = scene::read_scene(*file);
  if (!scene) return tl::unexpected(scene.error());
  return std::move(*scene);
}

Eigen::Vector2i view_size_px(const Configuration& configuration) {
  const auto size = configuration.setting("view").numbers("size_px");
  return {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

geometry::View view_in_use(const Configuration& configuration, const geometry::Vehicle& vehicle) {
  const Parameters& setting = configuration.setting("view");
  geometry::View view;
  view.size_px = view_size_px(configuration);
  view.metres_per_px = setting.given("metres_per_px")
                           ? setting.number("metres_per_px")
                           : geometry::default_metres_per_px(vehicle, view.size_px);
  const auto centre = setting.numbers("centre_m");
  view.centre_m = {centre[0], centre[1]};
  return view;
}

}  // namespace svchain
