#pragma once
// The rig as somebody with a measuring tape knows it: what a calibration of the scene's pictures starts from.
// Pure function, any thread.

#include "algorithms/scene/scene.h"

namespace svchain::scene {

/// The largest error of a nominal position, per axis of the vehicle: the scene's own figure, or 5 cm, less by
/// as much as the vehicle is shorter than 4.8 m.
double nominal_position_m(const Scene& scene);

/// The scene's rig with every camera moved by at most nominal_position_m() along each axis of the vehicle,
/// and turned by a rotation vector of at most scene.nominal.rotation_deg about each of them. The errors are
/// evenly distributed and follow from the scene's seed alone. Lenses stay as they are.
geometry::Rig nominal_rig(const Scene& scene);

}  // namespace svchain::scene
