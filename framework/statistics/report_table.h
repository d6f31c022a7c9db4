#pragma once
// A run's report for people: what contracts.md's report says, as a few tables of text. Parts that the report
// lacks are left out. Any thread.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace svchain {

std::string report_table(const nlohmann::json& report);

}  // namespace svchain
