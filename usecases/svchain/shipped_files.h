#pragma once
// Use cases, SoCs, scenes and faults by name or by file: the names of those that come with the program,
// anything else is a file. One thread.

#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/json/fault.h"

namespace svchain::program {

/// A folder of JSON files below the share folder, and what one of them is called.
struct Shelf {
  const char* folder;
  const char* what;
};
inline constexpr Shelf kUseCases = {"usecases", "use case"};
inline constexpr Shelf kScenes = {"configs/scenes", "scene"};
inline constexpr Shelf kSocs = {"configs/socs", "SoC"};
inline constexpr Shelf kFaultScripts = {"configs/faults", "fault file"};

/// Names on a shelf, sorted.
std::vector<std::string> shipped_names(const Shelf& shelf);
std::filesystem::path shipped_file(const Shelf& shelf, const std::string& name);

/// The file that NAME or FILE stands for. An unknown name is a fault that lists the known ones; whether a
/// file can be read is its reader's business.
Result<std::filesystem::path> find_file(const Shelf& shelf, const std::string& name_or_file);

}  // namespace svchain::program
