#include "framework/usecase/soc.h"

#include <algorithm>

#include "framework/usecase/place.h"

namespace svchain {

namespace {

using json::Document;
using json::Value;

SocCore read_core(const std::string& name, const Value& value) {
  SocCore core;
  core.name = name;
  if (name.empty()) value.fault("a core needs a name");
  value.only({"kind", "clock_mhz", "count", "cpus", "spins", "parks", "source", "note"});
  core.kind = value.required("kind").string();
  core.clock_mhz = value.optional("clock_mhz").number({1, 10000, "MHz"});
  core.count = static_cast<int>(value.optional("count").integer({1, 64}, 1));
  core.cpus = static_cast<int>(value.optional("cpus").integer({1, kMostCpus}, 1));
  core.spins = static_cast<int>(value.optional("spins").integer({0, 1000000}, core.spins));
  core.parks = value.optional("parks").boolean(core.parks);
  core.clock_basis = read_basis(value);
  return core;
}

void read_roles(const Value& roles, Soc& soc) {
  const auto names = soc.core_names();
  for (const auto& [role, value] : roles.members()) {
    const std::string core = value.string();
    const auto is_core = [&](const std::string& it) {
      return std::find(names.begin(), names.end(), it) != names.end();
    };
    if (is_core(role)) value.fault("a role cannot be named \"" + role + "\": so is a core");
    if (value.is_string() && !is_core(core)) {
      value.fault("there is no core \"" + core + "\"" + did_you_mean(core, names) +
                  " (cores: " + spoken_list(names) + ")");
    }
    soc.roles[role] = core;
  }
}

Result<Soc> read(const Document& document) {
  Faults faults;
  const Value root(document, faults);
  root.only({"name", "title", "cores", "roles", "costs"});
  if (!root.is_object()) return tl::unexpected(std::move(faults));
  Soc soc;
  soc.name = root.required("name").string();
  soc.title = root.optional("title").string(soc.name);
  const Value cores = root.required("cores");
  for (const auto& [name, value] : members_in_order(cores)) soc.cores.push_back(read_core(name, value));
  if (cores.is_object() && soc.cores.empty()) cores.fault("expected at least one core");
  read_roles(root.optional("roles"), soc);
  soc.costs = read_cost_model(root.optional("costs"));
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return soc;
}

}  // namespace

const SocCore* Soc::find(const std::string& core_or_role) const {
  const auto role = roles.find(core_or_role);
  const std::string& wanted = role == roles.end() ? core_or_role : role->second;
  const auto it =
      std::find_if(cores.begin(), cores.end(), [&](const auto& core) { return core.name == wanted; });
  return it == cores.end() ? nullptr : &*it;
}

std::vector<std::string> Soc::core_names() const {
  std::vector<std::string> names;
  for (const auto& core : cores) names.push_back(core.name);
  return names;
}

Result<Soc> read_soc(const std::filesystem::path& path) {
  const auto document = Document::read(path);
  if (!document) return tl::unexpected(document.error());
  return read(*document);
}

Result<Soc> parse_soc(const std::string& text, const std::string& file) {
  const auto document = Document::parse(text, file);
  if (!document) return tl::unexpected(document.error());
  return read(*document);
}

}  // namespace svchain
