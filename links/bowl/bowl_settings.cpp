#include "links/bowl/bowl_settings.h"

#include "algorithms/car/default_car.h"
#include "algorithms/car/model_file.h"

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

car::Orientation orientation_in_use(const Parameters& given) {
  car::Orientation orientation;
  if (given.text("car_up") == "z") orientation = {car::Axis::kPlusX, car::Axis::kPlusZ};
  return orientation;
}

}  // namespace

std::vector<ParameterDescription> surface_parameters() {
  return {choice("floor", kRectangle, {kRectangle, kEllipse}, "shape of the bowl's flat floor"),
          length("floor_length_m", "the floor's extent along the vehicle; left out: twice its length"),
          length("floor_width_m", "and across it; left out: three times its width"),
          length("rise_m", "from the floor's edge out to the rim; left out: half the vehicle's length"),
          length("height_m", "of the rim; 0 is flat ground; left out: the vehicle's length"),
          number("exponent", 2, {1, 16}, "", "how the wall rises: 1 is a cone, more begins gently"),
          number("blend_deg", synthesis::BlendShape{}.width_deg, {0, 90}, "deg",
                 "angle over which neighbouring cameras blend; 0 is a hard seam")};
}

bowl::BowlSurface surface_in_use(Configuration& configuration, const geometry::Vehicle& vehicle) {
  const Parameters& given = configuration.parameters();
  bowl::BowlSurface surface = bowl::default_surface(vehicle);
  if (given.text("floor") == kEllipse) surface.shape = bowl::FloorShape::kEllipse;
  take(given, "floor_length_m", surface.floor_length_m);
  take(given, "floor_width_m", surface.floor_width_m);
  take(given, "rise_m", surface.rise_m);
  take(given, "height_m", surface.height_m);
  surface.exponent = given.number("exponent");
  for (const Fault& fault : check(surface, vehicle))
    configuration.parameter_fault(fault.pointer.empty() ? "floor" : fault.pointer.substr(1), fault.message);
  return surface;
}

synthesis::BlendShape blend_in_use(const Parameters& parameters) {
  synthesis::BlendShape shape;
  shape.width_deg = parameters.number("blend_deg");
  return shape;
}

std::vector<ParameterDescription> car_parameters() {
  return {text("car", kDefaultCar, "default (made by the program), none, or a model: .obj, .gltf or .glb"),
          choice("car_up", "y", {"y", "z"}, "which way is up in the model's file; z: and x is forward"),
          number("car_opacity", 1, {0, 1}, "", "0 is not there, 1 as dense as it is")};
}

std::optional<car::CarModel> car_in_use(Configuration& configuration, const geometry::Vehicle& vehicle) {
  const std::string name = configuration.parameters().text("car");
  if (name == kNoCar) return std::nullopt;
  if (name == kDefaultCar) return car::default_car(vehicle);
  auto model = car::read_car_model(name, orientation_in_use(configuration.parameters()));
  if (model) return fit_to(*model, vehicle);
  for (const Fault& fault : model.error()) configuration.parameter_fault("car", fault.message);
  return std::nullopt;
}

}  // namespace svchain
