#include "links/bowl/bowl_settings.h"

#include <stdexcept>

#include "algorithms/car/default_car.h"
#include "algorithms/car/model_file.h"
#include "links/command_arguments.h"

namespace svchain {

namespace {

constexpr const char *kRectangle = "rectangle", *kEllipse = "ellipse";
constexpr const char *kNoCar = "none", *kDefaultCar = "default";

ParameterDescription length(const char* name, const char* help) {
  ParameterDescription d = number(name, 0, {0, 1000}, "m", help);
  d.fallback = nullptr;  // by the vehicle
  return d;
}

void take(const Parameters& given, const char* name, double& into) {
  if (given.given(name)) into = given.number(name);
}

/// What is given, over what is there.
bowl::BowlSurface with(bowl::BowlSurface surface, const Parameters& given) {
  if (given.given("floor"))
    surface.shape =
        given.text("floor") == kEllipse ? bowl::FloorShape::kEllipse : bowl::FloorShape::kRectangle;
  take(given, "floor_length_m", surface.floor_length_m);
  take(given, "floor_width_m", surface.floor_width_m);
  take(given, "rise_m", surface.rise_m);
  take(given, "height_m", surface.height_m);
  take(given, "exponent", surface.exponent);
  return surface;
}

std::string named(const Fault& fault) {
  return "bowl" + (fault.pointer.empty() ? "" : "." + fault.pointer.substr(1)) + ": " + fault.message;
}

car::Orientation orientation_in_use(const Parameters& given) {
  car::Orientation orientation;
  if (given.text("up") == "z") orientation = {car::Axis::kPlusX, car::Axis::kPlusZ};
  return orientation;
}

}  // namespace

SettingDescription bowl_setting() {
  return {"bowl",
          "the world around the vehicle in 3D: a flat floor and a wall",
          {choice("floor", kRectangle, {kRectangle, kEllipse}, "shape of the flat floor"),
           length("floor_length_m", "the floor's extent along the vehicle; left out: twice its length"),
           length("floor_width_m", "and across it; left out: three times its width"),
           length("rise_m", "from the floor's edge out to the rim; left out: the vehicle's length"),
           length("height_m", "of the rim; 0 is flat ground; left out: half the vehicle's length"),
           number("exponent", 2, {1, 16}, "", "how the wall rises: 1 is a cone, more begins gently"),
           number("blend_deg", synthesis::BlendShape{}.width_deg, {0, 90}, "deg",
                  "angle over which neighbouring cameras blend; 0 is a hard seam")}};
}

SettingDescription car_setting() {
  return {"car",
          "the vehicle as it is shown in 3D",
          {text("model", kDefaultCar, "default (made by the program), none, or a file: .obj, .gltf or .glb"),
           choice("up", "y", {"y", "z"}, "the axis that is up in the file; y: z is forward, z: x is forward"),
           number("opacity", 1, {0, 1}, "", "0 is not there, 1 as dense as it is")}};
}

bowl::BowlSurface surface_in_use(Configuration& configuration, const geometry::Vehicle& vehicle) {
  const bowl::BowlSurface surface = with(bowl::default_surface(vehicle), configuration.setting("bowl"));
  for (const Fault& fault : check(surface, vehicle)) configuration.fault(named(fault));
  return surface;
}

synthesis::BlendShape bowl_blend_in_use(const Configuration& configuration) {
  synthesis::BlendShape shape;
  shape.width_deg = configuration.setting("bowl").number("blend_deg");
  return shape;
}

bowl::BowlSurface changed(const bowl::BowlSurface& surface, const nlohmann::json& values,
                          const geometry::Vehicle& vehicle) {
  std::vector<ParameterDescription> descriptions = bowl_setting().parameters;
  descriptions.pop_back();  // blend_deg is no matter of the surface
  const bowl::BowlSurface result = with(surface, command_arguments(descriptions, values));
  std::string wrong;
  for (const Fault& fault : check(result, vehicle)) wrong += (wrong.empty() ? "" : "; ") + named(fault);
  if (!wrong.empty()) throw std::invalid_argument(wrong);
  return result;
}

std::optional<car::CarModel> car_in_use(Configuration& configuration, const geometry::Vehicle& vehicle) {
  const Parameters& given = configuration.setting("car");
  const std::string name = given.text("model");
  if (name == kNoCar || given.number("opacity") == 0) return std::nullopt;
  if (name == kDefaultCar) return car::default_car(vehicle);
  auto model = car::read_car_model(name, orientation_in_use(given));
  if (model) return fit_to(*model, vehicle);
  configuration.faults(model.error());
  return std::nullopt;
}

float car_opacity_in_use(const Configuration& configuration) {
  return static_cast<float>(configuration.setting("car").number("opacity"));
}

}  // namespace svchain
