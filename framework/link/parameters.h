#pragma once
// The values of a link's (or a setting's) parameters, complete and checked against their descriptions: a
// getter cannot fail on a described name. Plain value.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "framework/link/description.h"

namespace svchain {

class Parameters {
 public:
  /// All fallbacks.
  explicit Parameters(const std::vector<ParameterDescription>& descriptions = {});

  /// Checks an object of values: unknown names, wrong kinds and values out of range become faults at their
  /// places.
  void read(const std::vector<ParameterDescription>& descriptions, const json::Value& object);
  /// One value of a document.
  void read(const ParameterDescription& description, const json::Value& value);
  /// One value from outside JSON, as `--set` gives it: JSON if it parses, else a string; what a string or a
  /// choice gets is taken as it stands. The message names what is wrong, or is empty.
  std::string set(const std::vector<ParameterDescription>& descriptions, const std::string& name,
                  const std::string& value);
  /// For values known to be right: tests, and options that stand for a parameter.
  void put(const std::string& name, nlohmann::json value) { values_[name] = std::move(value); }

  bool given(const std::string& name) const { return !at(name).is_null(); }
  bool flag(const std::string& name) const { return at(name).get<bool>(); }
  long long integer(const std::string& name) const { return at(name).get<long long>(); }
  double number(const std::string& name) const { return at(name).get<double>(); }
  /// "" for a path that is not given.
  std::string text(const std::string& name) const {
    return given(name) ? at(name).get<std::string>() : std::string();
  }
  std::vector<double> numbers(const std::string& name) const { return at(name).get<std::vector<double>>(); }
  const nlohmann::json& json() const { return values_; }

 private:
  const nlohmann::json& at(const std::string& name) const { return values_.at(name); }
  nlohmann::json values_ = nlohmann::json::object();
};

}  // namespace svchain
