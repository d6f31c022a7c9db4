#include <algorithm>

#include "framework/usecase/entries.h"
#include "framework/usecase/place.h"

namespace svchain {

bool is_name(const std::string& name) {
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto inner = [&](char c) { return lower(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && lower(name.front()) && std::all_of(name.begin(), name.end(), inner);
}

std::string resolved(const std::string& name, const std::filesystem::path& folder) {
  const std::filesystem::path beside = folder / name;
  std::error_code error;
  return !name.empty() && std::filesystem::exists(beside, error) ? beside.string() : name;
}

void resolve_paths(const std::vector<ParameterDescription>& descriptions, const std::filesystem::path& folder,
                   Parameters& parameters) {
  for (const auto& d : descriptions) {
    if (!d.is_path || !parameters.given(d.name)) continue;
    parameters.put(d.name, resolved(parameters.text(d.name), folder));
  }
}

LinkEntry read_link(const std::string& name, const json::Value& value, const Catalogue& catalogue) {
  LinkEntry entry;
  entry.name = name;
  entry.origin = origin_of(value);
  if (!is_name(name)) value.fault("a link's name is lower case letters, digits and _, got \"" + name + "\"");
  value.only({"type", "core", "params", kOnErrorKey});
  entry.core = value.required("core").string();
  entry.core_origin = origin_of(value.optional("core"));
  entry.on_error =
      value.optional(kOnErrorKey).choice(kOnErrorNames, "stop") == "drop" ? OnError::kDrop : OnError::kStop;

  const json::Value type = value.required("type");
  const json::Value params = value.optional("params");
  entry.type = type.string();
  const auto link = catalogue.make(entry.type);
  if (!link) {
    const auto types = catalogue.link_types();
    if (type.is_string()) {
      type.fault("unknown link type \"" + entry.type + "\"" + did_you_mean(entry.type, types) +
                 " (known: " + spoken_list(types) + ")");
    }
    params.members();  // at least an object
    return entry;
  }
  const auto descriptions = link->describe().parameters;
  entry.parameters = Parameters(descriptions);
  entry.parameters.read(descriptions, params);
  resolve_paths(descriptions, value.document().folder(), entry.parameters);
  for (const auto& [parameter, given] :
       params.is_object() ? params.members() : std::vector<std::pair<std::string, json::Value>>{}) {
    entry.parameter_origins[parameter] = origin_of(given);
  }
  return entry;
}

}  // namespace svchain
