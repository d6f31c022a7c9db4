#include "links/bowl/viewpoint_settings.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "algorithms/bowl/path_json.h"
#include "algorithms/bowl/viewpoint_presets.h"
#include "links/command_arguments.h"

namespace svchain {

namespace {

constexpr const char* kOrbit = "orbit";
constexpr double kChange_s = 1;

ParameterDescription triple(std::string name, nlohmann::json fallback, std::string unit, std::string help) {
  ParameterDescription d = number(std::move(name), 0, {-1000, 1000}, std::move(unit), std::move(help));
  d.kind = Kind::kNumbers;
  d.count = 3;
  d.fallback = std::move(fallback);
  return d;
}

std::vector<std::string> viewpoint_names() {
  std::vector<std::string> names = bowl::preset_names();
  names.push_back(kOrbit);
  return names;
}

Eigen::Vector3d vector_of(const Parameters& given, const char* name, const Eigen::Vector3d& otherwise) {
  if (!given.given(name)) return otherwise;
  const auto three = given.numbers(name);
  return {three[0], three[1], three[2]};
}

std::string text_of(const Faults& faults) {
  std::string text;
  for (const Fault& fault : faults)
    text += (text.empty() ? "" : "; ") + (fault.pointer.empty() ? "" : fault.pointer.substr(1) + ": ") +
            fault.message;
  return text;
}

}  // namespace

std::vector<ParameterDescription> viewpoint_parameters() {
  return {
      text("viewpoint", "chase",
           "a preset (top, chase, front, left, right, rear, wheel_front_left, ...), orbit, or a path file"),
      triple("eye_m", nullptr, "m", "the eye's place, instead of a viewpoint's name"),
      triple("target_m", nlohmann::json{0, 0, 0}, "m", "what the eye looks at"),
      triple("up", nlohmann::json{0, 0, 1}, "", "what is up in the picture"),
      number("field_of_view_deg", 60, {1, 150}, "deg", "from the picture's upper to its lower edge")};
}

Result<ViewpointMotion::Source> ViewpointMotion::named(const std::string& name) const {
  if (name == kOrbit) return Source{{}, bowl::orbit(vehicle_, surface_)};
  if (const auto preset = bowl::preset(name, vehicle_, surface_)) return Source{*preset, {}};
  if (std::filesystem::path(name).extension() == ".json") {
    auto path = bowl::read_path(name, vehicle_, surface_);
    if (!path) return tl::unexpected(path.error());
    return Source{{}, std::move(*path)};
  }
  return fail("", "there is no viewpoint \"" + name + "\", expected " + spoken_list(viewpoint_names()) +
                      ", or a path file (.json)" + did_you_mean(name, viewpoint_names()));
}

Result<ViewpointMotion::Source> ViewpointMotion::placed(const Parameters& given) const {
  bowl::Viewpoint viewpoint;
  viewpoint.eye_m = vector_of(given, "eye_m", {0, 0, 0});
  viewpoint.target_m = vector_of(given, "target_m", {0, 0, 0});
  viewpoint.up = vector_of(given, "up", {0, 0, 1});
  if (given.given("field_of_view_deg")) viewpoint.field_of_view_deg = given.number("field_of_view_deg");
  Faults faults = check(viewpoint, vehicle_, surface_);
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return Source{viewpoint, {}};
}

Result<ViewpointMotion::Source> ViewpointMotion::wanted(const Parameters& given) const {
  return given.given("eye_m") ? placed(given) : named(given.text("viewpoint"));
}

void ViewpointMotion::configure(Configuration& configuration, const geometry::Vehicle& vehicle,
                                const bowl::BowlSurface& surface) {
  vehicle_ = vehicle;
  surface_ = surface;
  from_.reset();
  now_s_ = 0;
  given_ = configuration.parameters();
  const bool free = given_.given("eye_m");
  auto source = wanted(given_);
  if (source) {
    to_ = std::move(*source);
    now_ = to_.at(0);
    return;
  }
  for (const Fault& fault : source.error()) {
    if (!fault.file.empty())
      configuration.faults({fault});
    else
      configuration.parameter_fault(
          free ? fault.pointer.substr(std::min<size_t>(1, fault.pointer.size())) : "viewpoint",
          fault.message);
  }
}

bowl::Viewpoint ViewpointMotion::at(double time_s) {
  now_s_ = time_s;
  now_ = to_.at(time_s);
  if (!from_) return now_;
  const double share = (time_s - from_s_) / kChange_s;
  if (share >= 1)
    from_.reset();
  else
    now_ = bowl::inside_bowl(bowl::mixed(*from_, now_, std::max(share, 0.0)), surface_);
  return now_;
}

nlohmann::json ViewpointMotion::go_to(const nlohmann::json& arguments) {
  const Parameters given = command_arguments(viewpoint_parameters(), arguments);
  auto source = wanted(given);
  if (!source) throw std::invalid_argument(text_of(source.error()));
  given_ = given;
  start_change();
  to_ = std::move(*source);
  return {{"viewpoint", "within " + std::to_string(static_cast<int>(kChange_s)) + " s"}};
}

void ViewpointMotion::follow(const bowl::BowlSurface& surface) {
  if (surface == surface_) return;
  surface_ = surface;
  auto again = wanted(given_);
  start_change();
  to_ = again ? std::move(*again) : Source{bowl::inside_bowl(now_, surface_), {}};
}

void ViewpointMotion::start_change() {
  from_ = now_;
  from_s_ = now_s_;
}

}  // namespace svchain
