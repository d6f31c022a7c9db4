#include "tests/json_schema.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <sys/wait.h>

#include "tests/test_data.h"

namespace svchain::testing {

namespace {

const char* const kValidator = R"(
import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
sys.exit(0 if jsonschema.Draft202012Validator(schema).is_valid(json.load(open(sys.argv[2]))) else 3)
)";

}  // namespace

bool has_schema_validator() {
  return std::system("python3 -c 'import jsonschema' 2>/dev/null") == 0;
}

bool fits_schema(const std::string& kind, const std::string& text) {
  const TemporaryFolder folder;
  const auto script = folder.path() / "validate.py", file = folder.path() / "text.json";
  std::ofstream(script) << kValidator;
  std::ofstream(file) << text;
  const auto schema = project_folder() / "configs" / "schemas" / (kind + ".schema.json");
  const std::string command =
      "python3 '" + script.string() + "' '" + schema.string() + "' '" + file.string() + "'";
  switch (WEXITSTATUS(std::system(command.c_str()))) {
    case 0:
      return true;
    case 3:
      return false;
    default:
      throw std::runtime_error("the schema " + schema.string() + " is broken");
  }
}

}  // namespace svchain::testing
