#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "algorithms/geometry/lens_json.h"
#include "framework/fault/fault_script.h"
#include "links/builtin_links.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/shipped_files.h"

namespace svchain::program {

namespace {

constexpr size_t kNameWidth = 24;

std::string padded(const std::string& text, size_t width = kNameWidth) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text + " ";
}

std::string row(const std::string& name, const std::string& text) {
  return text.empty() ? name : padded(name) + text;
}

std::string title_of(const std::string& use_case) {
  const auto document = json::Document::read(shipped_file(kUseCases, use_case));
  if (!document || !document->root().is_object()) return {};
  const auto title = document->root().find("title");
  return title != document->root().end() && title->is_string() ? title->get<std::string>() : "";
}

void list_use_cases() {
  for (const std::string& name : shipped_names(kUseCases)) std::cout << row(name, title_of(name)) << '\n';
}

void list_socs() {
  for (const std::string& name : shipped_names(kSocs)) {
    const auto soc = read_soc(shipped_file(kSocs, name));
    if (!soc) continue;
    std::string cores;
    for (const SocCore& core : soc->cores) {
      cores += (cores.empty() ? "" : " ") + core.name;
      if (core.count > 1) cores += "(x" + std::to_string(core.count) + ")";
    }
    for (const auto& [role, core] : soc->roles) cores += ", " + role + " is " + core;
    std::cout << row(name, cores) << '\n';
  }
}

void list_lenses() {
  for (const std::string& model : geometry::lens_models()) std::cout << model << '\n';
}

/// "2 faults, 120 an hour at random"
std::string summary(const FaultScript& script) {
  std::string text;
  if (const size_t n = script.entries.size(); n > 0)
    text = std::to_string(n) + (n == 1 ? " fault" : " faults");
  if (!script.random) return text;
  std::ostringstream rate;
  rate << script.random->per_hour;
  return text + (text.empty() ? "" : ", ") + rate.str() + " an hour at random";
}

void list_faults() {
  for (const std::string& name : shipped_names(kFaultScripts)) {
    const auto script = read_fault_script(shipped_file(kFaultScripts, name));
    if (script) std::cout << row(name, summary(*script)) << '\n';
  }
}

std::string what_it_takes(const ParameterDescription& d) {
  json::Range range = d.range;
  range.unit = d.unit.c_str();
  switch (d.kind) {
    case Kind::kBoolean:
      return "true or false";
    case Kind::kInteger:
      return "whole number, " + range.text();
    case Kind::kNumber:
      return "number, " + range.text();
    case Kind::kString:
      return d.is_path ? "file" : "text";
    case Kind::kChoice:
      return spoken_list(d.choices);
    case Kind::kNumbers:
      return (d.count > 0 ? std::to_string(d.count) + " numbers" : "numbers") + ", each " + range.text();
  }
  return {};
}

void list_parameters(const std::vector<ParameterDescription>& parameters) {
  for (const ParameterDescription& d : parameters) {
    std::string text = what_it_takes(d);
    if (!d.fallback.is_null()) text += "; default " + d.fallback.dump();
    if (!d.help.empty()) text += "; " + d.help;
    std::cout << "    " << row(d.name, text) << '\n';
  }
}

void list_ports(const char* direction, const std::vector<PortDescription>& ports) {
  for (const PortDescription& port : ports) {
    std::string text = port.types.empty() ? "any type" : spoken_list(port.types);
    if (port.count > 0) text += " x" + std::to_string(port.count);
    if (port.optional) text += ", optional";
    if (!port.forwards.empty()) text += ", forwards " + spoken_list(port.forwards);
    if (!port.help.empty()) text += "; " + port.help;
    std::cout << "    " << row(direction + port.name, text) << '\n';
  }
}

void list_links() {
  Catalogue catalogue;
  add_builtin_links(catalogue);
  for (const std::string& type : catalogue.link_types()) {
    const LinkDescription description = catalogue.make(type)->describe();
    std::cout << row(type, description.help) << '\n';
    list_ports("in  ", description.inputs);
    list_ports("out ", description.outputs);
    list_parameters(description.parameters);
  }
  std::cout << "settings of a use case\n";
  for (const SettingDescription& setting : catalogue.settings()) {
    for (ParameterDescription d : setting.parameters) {
      d.name = setting.is_plain() ? setting.name : setting.name + "." + d.name;
      if (setting.is_plain()) d.help = setting.help + ": " + d.help;
      list_parameters({d});
    }
  }
}

struct Listing {
  const char* name;
  void (*print)();
};
constexpr Listing kListings[] = {{"usecases", list_use_cases},
                                 {"links", list_links},
                                 {"socs", list_socs},
                                 {"lenses", list_lenses},
                                 {"faults", list_faults}};

}  // namespace

int list(const std::string& what) {
  if (what.empty()) {
    for (const Listing& listing : kListings) {
      std::cout << (&listing == kListings ? "" : "\n") << listing.name << ":\n";
      listing.print();
    }
    return kDone;
  }
  std::vector<std::string> names;
  for (const Listing& listing : kListings) {
    names.push_back(listing.name);
    if (what != listing.name) continue;
    listing.print();
    return kDone;
  }
  return say(
      {{"list",
        {},
        {},
        "unknown \"" + what + "\"" + did_you_mean(what, names) + " (known: " + spoken_list(names) + ")"}});
}

}  // namespace svchain::program
