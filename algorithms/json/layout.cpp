#include "algorithms/json/layout.h"

#include <nlohmann/json.hpp>

namespace svchain::json {

namespace {

using nlohmann::ordered_json;

void write(const ordered_json& value, const std::string& indent, std::string& text) {
  const bool list = value.is_array() && !value.empty() && value.front().is_object();
  if (!list && !value.is_object()) {
    text += value.dump();
    return;
  }
  text += list ? "[" : "{";
  std::string separator = "\n";
  for (const auto& [key, member] : value.items()) {
    text += separator + indent + "  ";
    separator = ",\n";
    if (list) {
      text += member.dump();
    } else {
      text += ordered_json(key).dump() + ": ";
      write(member, indent + "  ", text);
    }
  }
  text += "\n" + indent + (list ? "]" : "}");
}

}  // namespace

std::string file_text(const ordered_json& value) {
  std::string text;
  write(value, "", text);
  return text + "\n";
}

}  // namespace svchain::json
