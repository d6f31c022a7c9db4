#pragma once
// A use case file as read: which links, on which cores, joined how. Syntax and names are checked against a
// catalogue; whether the graph makes sense is the planner's business (plan.h). Plain values.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/link/catalogue.h"

namespace svchain {

enum class Policy { kBlock, kDropOldest, kDropNewest, kLatest };
enum class OnError { kStop, kDrop };

/// Where something stands in its file, for faults that are found later.
struct Origin {
  std::string file;
  Location where;
  std::string pointer;
  Fault fault(std::string message) const { return {file, where, pointer, std::move(message)}; }
};

struct LinkEntry {
  std::string name;
  std::string type;
  std::string core;  // or a role
  Parameters parameters;
  OnError on_error = OnError::kStop;
  Origin origin;
  Origin core_origin;
  std::map<std::string, Origin> parameter_origins;
};

struct EdgeEntry {
  std::string from_link, from_port, to_link, to_port;
  int depth = 2;
  Policy policy = Policy::kBlock;
  bool feedback = false;
  Origin origin;
  /// "dup.out1 -> synthesis.frames"
  std::string name() const { return from_link + "." + from_port + " -> " + to_link + "." + to_port; }
};

/// How many CPUs a core has in this use case, instead of what the SoC file says.
struct CpusEntry {
  std::string core;  // or a role
  int cpus = 1;
  Origin origin;
};

struct UseCase {
  std::string name;
  std::string title;
  std::string file;
  std::string soc;
  Origin soc_origin;
  std::vector<CpusEntry> cpus;
  std::map<std::string, Parameters> settings;  // by setting name, complete
  std::vector<std::string> plugins;            // resolved against the file's folder
  std::vector<LinkEntry> links;                // in the file's order
  Origin links_origin;
  std::vector<EdgeEntry> edges;
};

/// One `--set LINK.PARAMETER=VALUE` (or SETTING.KEY=VALUE, SETTING=VALUE for a plain one, or
/// cpus.CORE=NUMBER).
struct Override {
  std::string text;
};

/// Plug-ins named in the file are needed before its links can be checked: reads only them.
Result<std::vector<std::string>> read_plugins(const std::filesystem::path& path);
/// What a file says as far as it can be read, with its faults: the planner may find more in it (plan_faults).
struct ReadUseCase {
  std::optional<UseCase> use_case;
  Faults faults;
};
ReadUseCase read_as_far_as_it_goes(const std::filesystem::path& path, const Catalogue& catalogue,
                                   const std::vector<Override>& overrides = {});
Result<UseCase> read_use_case(const std::filesystem::path& path, const Catalogue& catalogue,
                              const std::vector<Override>& overrides = {});
Result<UseCase> parse_use_case(const std::string& text, const std::string& file, const Catalogue& catalogue,
                               const std::vector<Override>& overrides = {});

}  // namespace svchain
