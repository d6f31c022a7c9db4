#pragma once
// Arguments of a command to a running link, checked like parameters: by name, kind and range.

#include <nlohmann/json.hpp>
#include <vector>

#include "framework/link/parameters.h"

namespace svchain {

/// What is not given stays null, whatever its description falls back to. Throws std::invalid_argument that
/// says everything that is wrong.
Parameters command_arguments(std::vector<ParameterDescription> descriptions, const nlohmann::json& given);

}  // namespace svchain
