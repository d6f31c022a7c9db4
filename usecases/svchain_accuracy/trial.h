#pragma once
// Simulated sets of calibration pictures whose truth is known: a vehicle, a lens model and a seed make one.
// Everything else is drawn from the seed. Pure functions: the same arguments give the same set.

#include <string>
#include <vector>

#include "algorithms/calibration/calibration.h"
#include "algorithms/scene/scene.h"

namespace svchain::accuracy {

/// The shipped scene of a vehicle ("car": parking, "toy": toy) with another rig, other charts and other
/// things about: poses and charts moved, lenses of the model, exposures that differ, noise of 2 grey levels,
/// boxes, posts and coloured paint. Throws std::runtime_error where the scene's file cannot be read.
scene::Scene trial_scene(const std::string& vehicle, const std::string& lens_model, uint64_t seed);

/// The same charts without their places.
std::vector<calibration::Chart> unposed(std::vector<calibration::Chart> charts);

/// What a calibration is given: the scene's nominal rig, its charts, and what the four cameras see.
calibration::CalibrationInput input_of(const scene::Scene& scene);

}  // namespace svchain::accuracy
