#include <algorithm>
#include <charconv>

#include "framework/usecase/entries.h"
#include "framework/usecase/soc.h"

namespace svchain {

namespace {

const std::string kForm =
    "expected LINK.PARAMETER=VALUE, LINK.on_error=stop|drop, SETTING.KEY=VALUE, SETTING=VALUE or "
    "cpus.CORE=NUMBER";

const SettingDescription* find(const std::vector<SettingDescription>& settings, const std::string& name) {
  const auto it =
      std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.name == name; });
  return it == settings.end() ? nullptr : &*it;
}

std::string nobody(const std::string& name, const Catalogue& catalogue, const UseCase& use_case) {
  std::vector<std::string> names;
  for (const auto& link : use_case.links) names.push_back(link.name);
  for (const auto& setting : catalogue.settings()) names.push_back(setting.name);
  names.push_back(kCpusKey);
  return "there is no link or setting \"" + name + "\"" + did_you_mean(name, names) + " (" + kForm +
         "; known: " + spoken_list(names) + ")";
}

/// Returns what is wrong, or "".
std::string set_setting(const SettingDescription& setting, const std::string& key, const std::string& value,
                        Parameters& parameters) {
  if (setting.is_plain()) {
    if (!key.empty()) return "\"" + setting.name + "\" has no parts, expected " + setting.name + "=VALUE";
    return parameters.set(setting.parameters, "value", value);
  }
  if (key.empty()) return "\"" + setting.name + "\" has parts, expected " + setting.name + ".KEY=VALUE";
  return parameters.set(setting.parameters, key, value);
}

std::string set_on_error(LinkEntry& link, const std::string& value) {
  const auto name = std::find(kOnErrorNames.begin(), kOnErrorNames.end(), value);
  if (name == kOnErrorNames.end())
    return "expected " + spoken_list(kOnErrorNames) + ", got \"" + value + "\"";
  link.on_error = static_cast<OnError>(name - kOnErrorNames.begin());
  return {};
}

std::string set_parameter(LinkEntry& link, const std::string& parameter, const std::string& value,
                          const Catalogue& catalogue, const Origin& origin) {
  if (parameter.empty()) return "which parameter of \"" + link.name + "\"? " + kForm;
  if (parameter == kOnErrorKey) return set_on_error(link, value);
  const auto made = catalogue.make(link.type);
  if (!made) return {};  // the unknown type is a fault already
  const std::string wrong = link.parameters.set(made->describe().parameters, parameter, value);
  if (wrong.empty()) link.parameter_origins[parameter] = origin;
  return wrong;
}

std::string set_cpus(const std::string& core, const std::string& value, const Origin& origin,
                     UseCase& use_case) {
  int cpus = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), cpus);
  if (error != std::errc() || end != value.data() + value.size() || cpus < 1 || cpus > kMostCpus)
    return "expected a whole number from 1 to " + std::to_string(kMostCpus) + ", got \"" + value + "\"";
  use_case.cpus.push_back({core, cpus, origin});
  return {};
}

std::string apply_one(const std::string& text, const Catalogue& catalogue, UseCase& use_case,
                      const Origin& origin) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return kForm + ", got \"" + text + "\"";
  const std::string target = text.substr(0, equals);
  const std::string value = text.substr(equals + 1);
  const auto dot = target.find('.');
  const std::string name = target.substr(0, dot);
  const std::string key = dot == std::string::npos ? "" : target.substr(dot + 1);

  const auto link = std::find_if(use_case.links.begin(), use_case.links.end(),
                                 [&](const auto& entry) { return entry.name == name; });
  if (link != use_case.links.end()) return set_parameter(*link, key, value, catalogue, origin);
  if (const auto* setting = find(catalogue.settings(), name)) {
    return set_setting(*setting, key, value, use_case.settings[name]);
  }
  if (name == kCpusKey) return set_cpus(key, value, origin, use_case);
  return nobody(name, catalogue, use_case);
}

}  // namespace

void apply(const std::vector<Override>& overrides, const Catalogue& catalogue, UseCase& use_case,
           Faults& faults) {
  for (const Override& override : overrides) {
    const Origin origin{"--set " + override.text, {}, {}};
    const std::string wrong = apply_one(override.text, catalogue, use_case, origin);
    if (!wrong.empty()) faults.push_back(origin.fault(wrong));
  }
}

}  // namespace svchain
