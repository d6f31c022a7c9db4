#pragma once
// YAML files of other programs, read by the same strict rules as JSON: the file becomes a document, values
// are taken from it with json::Value, and what was found wrong is then told at its line in the YAML.

#include <filesystem>
#include <functional>

#include "algorithms/json/value.h"

namespace svchain::geometry {

/// Hands the file's root to `read` and returns all faults: the file's own or those that `read` recorded.
Faults read_yaml(const std::filesystem::path& path, const std::function<void(const json::Value&)>& read);

}  // namespace svchain::geometry
