#pragma once
// What a use case may refer to: link types and settings. Filled explicitly by one function
// (links/builtin_links.cpp) and by plug-ins; nothing registers itself. Not thread-safe: filled first, read
// afterwards.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/link/link.h"

namespace svchain {

/// A group of parameters that the links of a use case share, at the top level of its file: "view", or a plain
/// value such as "rig", which is a group with a single parameter named "value".
struct SettingDescription {
  std::string name;
  std::string help;
  std::vector<ParameterDescription> parameters;
  bool is_plain() const { return parameters.size() == 1 && parameters.front().name == "value"; }
};

class Catalogue {
 public:
  /// The link's own describe().type is its name. Returns false if the name is taken.
  bool add(LinkFactory factory);
  void add(SettingDescription setting) { settings_.push_back(std::move(setting)); }

  /// Null where there is no such type.
  std::unique_ptr<Link> make(const std::string& type) const;
  std::vector<std::string> link_types() const;
  const std::vector<SettingDescription>& settings() const { return settings_; }

 private:
  std::map<std::string, LinkFactory> factories_;
  std::vector<SettingDescription> settings_;
};

}  // namespace svchain
