#pragma once
// The parts of a use case file, each read strictly. Internal to the reader.

#include <optional>
#include <string>
#include <vector>

#include "algorithms/json/value.h"
#include "framework/usecase/use_case.h"

namespace svchain {

/// In the order of the enums.
inline const std::vector<std::string> kPolicyNames = {"block", "drop_oldest", "drop_newest", "latest"};
inline const std::vector<std::string> kOnErrorNames = {"stop", "drop"};

constexpr int kDeepestEdge = 64;

/// What becomes of a call that throws: a link's key, and its name for --set.
inline const std::string kOnErrorKey = "on_error";
/// The key for the cores' CPUs, and their name for --set.
inline const std::string kCpusKey = "cpus";

/// Names of links and ports: [a-z][a-z0-9_]*.
bool is_name(const std::string& name);

/// An entry of "links"; its parameters are complete even where faults were found.
LinkEntry read_link(const std::string& name, const json::Value& value, const Catalogue& catalogue);

/// An entry of "edges", nothing where it cannot be understood at all.
std::optional<EdgeEntry> read_edge(const json::Value& value, const std::vector<std::string>& link_names);

/// A file named relative to the use case's folder, if it is there; else the name as it stands.
std::string resolved(const std::string& name, const std::filesystem::path& folder);
void resolve_paths(const std::vector<ParameterDescription>& descriptions, const std::filesystem::path& folder,
                   Parameters& parameters);

/// Applies `--set` texts to a use case; what does not fit becomes a fault of that option.
void apply(const std::vector<Override>& overrides, const Catalogue& catalogue, UseCase& use_case,
           Faults& faults);

}  // namespace svchain
