#pragma once
// JSON as files are written that people read: an object's members on lines of their own, an array on one, but
// an array of objects with each of them on one. Numbers are exact. Pure.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace svchain::json {

/// The text of a whole file, its end of line included.
std::string file_text(const nlohmann::ordered_json& value);

}  // namespace svchain::json
