#pragma once
// Lenses as rig files write them (contracts: "Rig"). One table in lens_json.cpp lists all models.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "algorithms/geometry/lens.h"
#include "algorithms/json/value.h"

namespace svchain::geometry {

/// Names of all models, as `lens.model` spells them.
std::vector<std::string> lens_models();

/// Reads a lens; null after a fault, which stands in the value's list of faults then.
LensPtr read_lens(const json::Value& lens);

/// The lens as a rig file has it, every number exact.
nlohmann::ordered_json lens_json(const Lens& lens);

}  // namespace svchain::geometry
