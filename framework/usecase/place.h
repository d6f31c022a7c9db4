#pragma once
// Where values stand in their file, and in which order. Internal to the readers of the framework.

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "algorithms/json/value.h"
#include "framework/usecase/use_case.h"

namespace svchain {

inline Origin origin_of(const json::Value& value) {
  return {value.document().file(), value.document().locate(value.pointer()), value.pointer()};
}

/// The members of an object as they follow each other in the file.
inline std::vector<std::pair<std::string, json::Value>> members_in_order(const json::Value& object) {
  auto members = object.members();
  const auto place = [](const auto& member) {
    const Location where = member.second.document().locate(member.second.pointer());
    return std::tuple(where.line, where.column);
  };
  std::stable_sort(members.begin(), members.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return members;
}

}  // namespace svchain
