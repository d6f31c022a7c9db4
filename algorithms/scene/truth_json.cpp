#include "algorithms/scene/truth_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "algorithms/geometry/angles.h"
#include "algorithms/scene/sensor.h"

namespace svchain::scene {

namespace {

using nlohmann::ordered_json;

/// Digits that mean something: what was 6 degrees in the scene's file is 6 degrees again.
double rounded(double value, double per_unit) {
  return std::round(value * per_unit) / per_unit;
}

ordered_json curve(const Response& response, int channel) {
  ordered_json levels = ordered_json::array();
  for (int light = 0; light < 256; ++light) levels.push_back(rounded(respond(response, channel, light), 1e4));
  return levels;
}

}  // namespace

std::string responses_text(const std::array<Response, 4>& responses) {
  ordered_json root;
  for (size_t i = 0; i < responses.size(); ++i) {
    const Response& response = responses[i];
    root[geometry::kCameraNames[i]] = {
        {"gain_bgr", response.gain_bgr},
        {"gamma", response.gamma},
        {"falloff", response.falloff},
        {"noise_sigma", response.noise_sigma},
        {"curve", {{"b", curve(response, 0)}, {"g", curve(response, 1)}, {"r", curve(response, 2)}}}};
  }
  return root.dump() + "\n";
}

}  // namespace svchain::scene
