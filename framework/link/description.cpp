#include "framework/link/description.h"

#include <algorithm>

namespace svchain {

namespace {

ParameterDescription described(std::string name, Kind kind, nlohmann::json fallback, std::string help) {
  ParameterDescription d;
  d.name = std::move(name);
  d.kind = kind;
  d.fallback = std::move(fallback);
  d.help = std::move(help);
  return d;
}

const PortDescription* named(const std::vector<PortDescription>& ports, const std::string& name) {
  const auto it =
      std::find_if(ports.begin(), ports.end(), [&](const auto& port) { return port.name == name; });
  return it == ports.end() ? nullptr : &*it;
}

}  // namespace

ParameterDescription boolean(std::string name, bool fallback, std::string help) {
  return described(std::move(name), Kind::kBoolean, fallback, std::move(help));
}

ParameterDescription integer(std::string name, long long fallback, json::Range range, std::string unit,
                             std::string help) {
  ParameterDescription d = described(std::move(name), Kind::kInteger, fallback, std::move(help));
  d.range = range;
  d.unit = std::move(unit);
  return d;
}

ParameterDescription number(std::string name, double fallback, json::Range range, std::string unit,
                            std::string help) {
  ParameterDescription d = described(std::move(name), Kind::kNumber, fallback, std::move(help));
  d.range = range;
  d.unit = std::move(unit);
  return d;
}

ParameterDescription text(std::string name, std::string fallback, std::string help) {
  return described(std::move(name), Kind::kString, std::move(fallback), std::move(help));
}

ParameterDescription path(std::string name, std::string help) {
  ParameterDescription d = described(std::move(name), Kind::kString, nullptr, std::move(help));
  d.is_path = true;
  return d;
}

ParameterDescription choice(std::string name, std::string fallback, std::vector<std::string> choices,
                            std::string help) {
  ParameterDescription d = described(std::move(name), Kind::kChoice, std::move(fallback), std::move(help));
  d.choices = std::move(choices);
  return d;
}

const PortDescription* LinkDescription::input(const std::string& name) const {
  return named(inputs, name);
}

const PortDescription* LinkDescription::output(const std::string& name) const {
  return named(outputs, name);
}

}  // namespace svchain
