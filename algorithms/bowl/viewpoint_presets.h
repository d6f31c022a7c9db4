#pragma once
// Viewpoints that every vehicle has, by name, scaled to its size so that a toy, a car and a van all come out
// well. Any thread.

#include <optional>
#include <string>
#include <vector>

#include "algorithms/bowl/viewpoint.h"

namespace svchain::bowl {

/// "top" from straight above, forward being up; "chase" from behind and above, looking ahead; "front",
/// "left", "right" and "rear" from that side at the vehicle; "wheel_front_left" and so on close, down at a
/// wheel.
const std::vector<std::string>& preset_names();

/// A preset by its name, nothing for a name that is none. Where the bowl's wall would be in the way, the eye
/// is moved towards its target.
std::optional<Viewpoint> preset(const std::string& name, const geometry::Vehicle& vehicle,
                                const BowlSurface& surface);

/// The viewpoint as it is, or with its eye moved towards its target until it is inside the bowl.
Viewpoint inside_bowl(Viewpoint viewpoint, const BowlSurface& surface);

}  // namespace svchain::bowl
