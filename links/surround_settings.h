#pragma once
// The settings that the links of a surround view share, resolved: which rig, and which view of the ground.
// Called while configuring.

#include <optional>

#include "algorithms/geometry/view.h"
#include "algorithms/scene/scene.h"
#include "framework/link/link.h"

namespace svchain {

/// The rig named by the setting "rig"; without one, that of the simulated scene named by the setting "input".
Result<geometry::Rig> rig_in_use(const Configuration& configuration);

/// The rig that an alignment starts from: named by the setting "rig"; without one, that of the simulated
/// scene as a measuring tape has it (scene/nominal_rig.h), for its true one would leave nothing to align.
Result<geometry::Rig> nominal_rig_in_use(const Configuration& configuration);
/// The same by the settings' texts; "": not given.
Result<geometry::Rig> nominal_rig_of(const std::string& rig, const std::string& input);

/// The simulated scene named by the setting "input"; nothing where frames come from elsewhere.
Result<std::optional<scene::Scene>> simulated_scene(const Configuration& configuration);
/// The same by the setting's text.
Result<std::optional<scene::Scene>> simulated_scene(const std::string& input);

/// The size of the composite alone, which needs no rig.
Eigen::Vector2i view_size_px(const Configuration& configuration);

/// The view, with a scale that fits the vehicle where the setting leaves it open.
geometry::View view_in_use(const Configuration& configuration, const geometry::Vehicle& vehicle);

}  // namespace svchain
