#pragma once
// Texts against the shipped JSON Schemas, by python3's jsonschema where it is there.

#include <string>

namespace svchain::testing {

bool has_schema_validator();

/// `kind` as in configs/schemas/KIND.schema.json. Throws std::runtime_error where the schema itself is
/// broken.
bool fits_schema(const std::string& kind, const std::string& text);

}  // namespace svchain::testing
