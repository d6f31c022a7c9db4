#pragma once
// The parameters that links of the 3D view share: the bowl's surface, how cameras blend on it, and the car in
// its middle. Called while describing and configuring; what is wrong becomes a fault of the configuration.

#include <optional>
#include <vector>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/car/car_model.h"
#include "algorithms/synthesis/blend_shape.h"
#include "framework/link/link.h"

namespace svchain {

std::vector<ParameterDescription> surface_parameters();
/// Lengths that are not given come from the vehicle.
bowl::BowlSurface surface_in_use(Configuration& configuration, const geometry::Vehicle& vehicle);
synthesis::BlendShape blend_in_use(const Parameters& parameters);

std::vector<ParameterDescription> car_parameters();
/// Scaled to the vehicle; nothing for car "none".
std::optional<car::CarModel> car_in_use(Configuration& configuration, const geometry::Vehicle& vehicle);

}  // namespace svchain
