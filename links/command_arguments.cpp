#include "links/command_arguments.h"

#include <stdexcept>

namespace svchain {

Parameters command_arguments(std::vector<ParameterDescription> descriptions, const nlohmann::json& given) {
  for (ParameterDescription& description : descriptions) description.fallback = nullptr;
  Parameters arguments(descriptions);
  if (!given.is_object()) throw std::invalid_argument("expected an object, got " + given.dump());
  std::string wrong;
  for (const auto& [name, value] : given.items()) {
    const std::string what =
        arguments.set(descriptions, name, value.is_string() ? value.get<std::string>() : value.dump());
    if (!what.empty()) wrong += (wrong.empty() ? "" : "; ") + name + ": " + what;
  }
  if (!wrong.empty()) throw std::invalid_argument(wrong);
  return arguments;
}

}  // namespace svchain
