#pragma once
// What is true of a scene, as texts for whoever calibrates from its pictures or judges what was made of them.
// Pure functions, any thread.

#include <string>

#include "algorithms/scene/scene.h"

namespace svchain::scene {

/// {"front": {"gain_bgr", "gamma", "falloff", "noise_sigma", "curve": {"b", "g", "r"}}, "right", ...}: each
/// curve has what respond() makes of the light 0..255, without falloff and noise, to four decimals.
std::string responses_text(const std::array<Response, 4>& responses);

}  // namespace svchain::scene
