#pragma once
// Lenses of every model that are like a given one: what a maker would have printed or a user fitted for it.
// Pure functions.

#include <string>
#include <vector>

#include "algorithms/geometry/lens.h"

namespace svchain::accuracy {

/// Every model, as rig files spell it.
inline const std::vector<std::string> kLensModels = {
    "kannala_brandt", "table", "polynomial", "ocam", "mei", "eucm", "double_sphere", "pinhole"};

/// A lens of the model whose pixels are next to those of `target` (a Kannala-Brandt lens) in the least
/// squares sense, up to 90 degrees from the axis. A pinhole cannot be: it gets the target's centre, three
/// quarters of its focal length and the distortion that squeezes 144 degrees into 1280 px.
geometry::LensPtr lens_like(const std::string& model, const geometry::Lens& target);

}  // namespace svchain::accuracy
