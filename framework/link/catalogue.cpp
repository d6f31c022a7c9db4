#include "framework/link/catalogue.h"

namespace svchain {

bool Catalogue::add(LinkFactory factory) {
  std::string type = factory()->describe().type;
  return factories_.emplace(std::move(type), std::move(factory)).second;
}

std::unique_ptr<Link> Catalogue::make(const std::string& type) const {
  const auto it = factories_.find(type);
  return it == factories_.end() ? nullptr : it->second();
}

std::vector<std::string> Catalogue::link_types() const {
  std::vector<std::string> types;
  for (const auto& [type, factory] : factories_) types.push_back(type);
  return types;
}

}  // namespace svchain
