#include "framework/link/parameters.h"

#include <algorithm>

#include "algorithms/json/document.h"

namespace svchain {

namespace {

const ParameterDescription* find(const std::vector<ParameterDescription>& descriptions,
                                 const std::string& name) {
  const auto it =
      std::find_if(descriptions.begin(), descriptions.end(), [&](const auto& d) { return d.name == name; });
  return it == descriptions.end() ? nullptr : &*it;
}

std::string unknown(const std::string& name, const std::vector<ParameterDescription>& descriptions) {
  const std::string what = "unknown parameter \"" + name + "\"";
  if (descriptions.empty()) return what + ", there are none here";
  std::vector<std::string> names;
  for (const auto& d : descriptions) names.push_back(d.name);
  return what + did_you_mean(name, names) + " (known: " + spoken_list(names) + ")";
}

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The text of a value from a command line as JSON.
std::string as_json(const std::string& value, const ParameterDescription* d) {
  const auto parsed = json::Document::parse(value, {});
  const bool wants_text = d && (d->kind == Kind::kString || d->kind == Kind::kChoice);
  return parsed && (!wants_text || parsed->root().is_string()) ? value : quoted(value);
}

}  // namespace

Parameters::Parameters(const std::vector<ParameterDescription>& descriptions) {
  for (const auto& d : descriptions) values_[d.name] = d.fallback;
}

void Parameters::read(const std::vector<ParameterDescription>& descriptions, const json::Value& object) {
  for (const auto& [name, value] : object.members()) {
    if (const ParameterDescription* d = find(descriptions, name)) {
      read(*d, value);
    } else {
      value.fault(unknown(name, descriptions));
    }
  }
}

void Parameters::read(const ParameterDescription& d, const json::Value& value) {
  if (!value) return;
  json::Range range = d.range;
  range.unit = d.unit.c_str();
  nlohmann::json& slot = values_[d.name];
  switch (d.kind) {
    case Kind::kBoolean:
      slot = value.boolean();
      break;
    case Kind::kInteger:
      slot = value.integer(range);
      break;
    case Kind::kNumber:
      slot = value.number(range);
      break;
    case Kind::kString:
      slot = value.string();
      break;
    case Kind::kChoice:
      slot = value.choice(d.choices);
      break;
    case Kind::kNumbers:
      slot = value.numbers(d.count, range);
      break;
  }
}

std::string Parameters::set(const std::vector<ParameterDescription>& descriptions, const std::string& name,
                            const std::string& value) {
  const ParameterDescription* d = find(descriptions, name);
  if (!d) return unknown(name, descriptions);
  const auto document = json::Document::parse(as_json(value, d), {});
  if (!document) return document.error().front().message;
  Faults faults;
  Parameters changed = *this;
  changed.read(*d, json::Value(*document, faults));
  if (!faults.empty()) return faults.front().message;
  *this = std::move(changed);
  return {};
}

}  // namespace svchain
