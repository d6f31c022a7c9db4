#include "framework/usecase/use_case.h"

#include <map>

#include "framework/usecase/entries.h"
#include "framework/usecase/place.h"
#include "framework/usecase/soc.h"

namespace svchain {

namespace {

using json::Document;
using json::Value;

std::vector<std::string> read_plugin_list(const Value& root) {
  std::vector<std::string> plugins;
  for (const Value& item : root.optional("plugins").items()) {
    plugins.push_back(resolved(item.string(), root.document().folder()));
  }
  return plugins;
}

void check_keys(const Value& root, const Catalogue& catalogue) {
  std::vector<std::string> keys = {"name", "title", "soc", kCpusKey, "plugins", "links", "edges"};
  for (const auto& setting : catalogue.settings()) keys.push_back(setting.name);
  root.only(keys);
}

std::vector<CpusEntry> read_cpus(const Value& root) {
  std::vector<CpusEntry> cpus;
  for (const auto& [core, value] : members_in_order(root.optional(kCpusKey)))
    cpus.push_back({core, static_cast<int>(value.integer({1, kMostCpus}, 1)), origin_of(value)});
  return cpus;
}

std::map<std::string, Parameters> read_settings(const Value& root, const Catalogue& catalogue) {
  std::map<std::string, Parameters> settings;
  for (const auto& setting : catalogue.settings()) {
    Parameters& parameters = settings[setting.name] = Parameters(setting.parameters);
    const Value given = root.optional(setting.name);
    if (setting.is_plain()) {
      parameters.read(setting.parameters.front(), given);
    } else {
      parameters.read(setting.parameters, given);
    }
    resolve_paths(setting.parameters, root.document().folder(), parameters);
  }
  return settings;
}

std::vector<LinkEntry> read_links(const Value& root, const Catalogue& catalogue) {
  const Value links = root.required("links");
  std::vector<LinkEntry> entries;
  for (const auto& [name, value] : members_in_order(links)) {
    entries.push_back(read_link(name, value, catalogue));
    if (name == kCpusKey) value.fault("a link cannot be named \"" + name + "\": so are the cores' CPUs");
    for (const auto& setting : catalogue.settings()) {
      if (setting.name == name) value.fault("a link cannot be named \"" + name + "\": so is a setting");
    }
  }
  if (links.is_object() && entries.empty()) links.fault("expected at least one link");
  return entries;
}

std::vector<EdgeEntry> read_edges(const Value& root, const std::vector<LinkEntry>& links) {
  std::vector<std::string> names;
  for (const auto& link : links) names.push_back(link.name);
  std::vector<EdgeEntry> edges;
  std::map<std::string, Location> seen;
  for (const Value& item : root.optional("edges").items()) {
    const auto edge = read_edge(item, names);
    if (!edge) continue;
    const auto [first, fresh] = seen.emplace(edge->name(), edge->origin.where);
    if (fresh) {
      edges.push_back(*edge);
    } else {
      item.fault("the edge \"" + edge->name() + "\" stands twice, first in line " +
                 std::to_string(first->second.line));
    }
  }
  return edges;
}

ReadUseCase read(const Document& document, const Catalogue& catalogue,
                 const std::vector<Override>& overrides) {
  Faults faults;
  const Value root(document, faults);
  if (!root.is_object()) {
    root.members();  // says so
    return {std::nullopt, std::move(faults)};
  }
  check_keys(root, catalogue);
  UseCase use_case;
  use_case.file = document.file();
  use_case.name = root.required("name").string();
  use_case.title = root.optional("title").string();
  use_case.soc = root.optional("soc").string();
  use_case.soc_origin = origin_of(root.optional("soc"));
  use_case.cpus = read_cpus(root);
  use_case.plugins = read_plugin_list(root);
  use_case.settings = read_settings(root, catalogue);
  use_case.links = read_links(root, catalogue);
  use_case.links_origin = origin_of(root.optional("links"));
  use_case.edges = read_edges(root, use_case.links);
  apply(overrides, catalogue, use_case, faults);
  return {std::move(use_case), std::move(faults)};
}

Result<UseCase> sound(ReadUseCase read) {
  if (!read.faults.empty()) return tl::unexpected(std::move(read.faults));
  return std::move(*read.use_case);
}

}  // namespace

Result<std::vector<std::string>> read_plugins(const std::filesystem::path& path) {
  const auto document = Document::read(path);
  if (!document) return tl::unexpected(document.error());
  Faults faults;
  auto plugins = read_plugin_list(Value(*document, faults));
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return plugins;
}

ReadUseCase read_as_far_as_it_goes(const std::filesystem::path& path, const Catalogue& catalogue,
                                   const std::vector<Override>& overrides) {
  const auto document = Document::read(path);
  if (!document) return {std::nullopt, document.error()};
  return read(*document, catalogue, overrides);
}

Result<UseCase> read_use_case(const std::filesystem::path& path, const Catalogue& catalogue,
                              const std::vector<Override>& overrides) {
  return sound(read_as_far_as_it_goes(path, catalogue, overrides));
}

Result<UseCase> parse_use_case(const std::string& text, const std::string& file, const Catalogue& catalogue,
                               const std::vector<Override>& overrides) {
  const auto document = Document::parse(text, file);
  if (!document) return tl::unexpected(document.error());
  return sound(read(*document, catalogue, overrides));
}

}  // namespace svchain
