#pragma once
// Where the files that come with the program are: $SVCHAIN_SHARE, or ../share/svchain beside the program, or
// the folder that it was built from. Any thread.

#include <filesystem>
#include <string>

#include "algorithms/json/fault.h"

namespace svchain {

/// Has usecases/ and configs/ in it.
std::filesystem::path share_folder();
/// socs/, rigs/, lenses/, charts/, scenes/.
std::filesystem::path configs_folder();

/// A file of that name in a folder of configs/, else a file of one's own. The fault's file is `named`; `what`
/// it is: "scene".
Result<std::filesystem::path> find_config(const std::string& folder, const std::string& what,
                                          const std::string& named);

}  // namespace svchain
