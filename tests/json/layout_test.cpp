#include "algorithms/json/layout.h"

#include <nlohmann/json.hpp>

#include "tests/catch.h"

using nlohmann::ordered_json;
using svchain::json::file_text;

TEST_CASE(
    "members stand on lines of their own in their order, arrays on one, and objects of an array on one "
    "each") {
  const ordered_json value = {{"b", {{"x", 1.5}, {"empty", ordered_json::object()}}},
                              {"a", {1, 2, 3}},
                              {"list", {{{"id", 1}, {"at", {0, 1}}}, {{"id", 2}}}},
                              {"none", ordered_json::array()}};
  const std::string text = file_text(value);
  CHECK(text == R"({
  "b": {
    "x": 1.5,
    "empty": {
    }
  },
  "a": [1,2,3],
  "list": [
    {"id":1,"at":[0,1]},
    {"id":2}
  ],
  "none": []
}
)");
  CHECK(ordered_json::parse(text) == value);
}
