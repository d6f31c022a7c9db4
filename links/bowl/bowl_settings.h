#pragma once
// The settings "bowl" and "car", which the links of the 3D view share: the bowl's surface, how cameras blend
// on it, and the car in its middle. Called while describing and configuring; what is wrong becomes a fault of
// the configuration. changed() is for commands while running, on the link's core.

#include <nlohmann/json.hpp>
#include <optional>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/car/car_model.h"
#include "algorithms/synthesis/blend_shape.h"
#include "framework/link/catalogue.h"
#include "framework/link/link.h"

namespace svchain {

SettingDescription bowl_setting();
SettingDescription car_setting();

/// Lengths that are not given come from the vehicle.
bowl::BowlSurface surface_in_use(Configuration& configuration, const geometry::Vehicle& vehicle);
synthesis::BlendShape bowl_blend_in_use(const Configuration& configuration);

/// The surface with other values, by the setting's names: {"height_m": 3}. Throws std::invalid_argument that
/// names every one that is no good.
bowl::BowlSurface changed(const bowl::BowlSurface& surface, const nlohmann::json& values,
                          const geometry::Vehicle& vehicle);

/// Scaled to the vehicle; nothing for model "none".
std::optional<car::CarModel> car_in_use(Configuration& configuration, const geometry::Vehicle& vehicle);
float car_opacity_in_use(const Configuration& configuration);

}  // namespace svchain
