#pragma once
// What an alignment of four cameras came to, whichever way it went: enough to build a geometric LUT, and what
// the report says of it. Plain value.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "algorithms/synthesis/geometric_lut.h"

namespace svchain {

struct GroundAlignment {
  geometry::Rig rig;  // lenses as the alignment left them
  synthesis::RaysFromGround rays;
  std::vector<std::string> reasons;  // why it is not to be trusted, camera first; none: accepted
  nlohmann::json accuracy = nlohmann::json::object();  // the report's part
};

}  // namespace svchain
