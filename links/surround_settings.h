#pragma once
// The settings that the links of a surround view share, resolved: which rig, and which view of the ground.
// Called while configuring.

#include "algorithms/geometry/view.h"
#include "framework/link/link.h"

namespace svchain {

/// The rig named by the setting "rig"; without one, that of the simulated scene named by the setting "input".
Result<geometry::Rig> rig_in_use(const Configuration& configuration);

/// The size of the composite alone, which needs no rig.
Eigen::Vector2i view_size_px(const Configuration& configuration);

/// The view, with a scale that fits the vehicle where the setting leaves it open.
geometry::View view_in_use(const Configuration& configuration, const geometry::Vehicle& vehicle);

}  // namespace svchain
