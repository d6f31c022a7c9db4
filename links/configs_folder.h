#pragma once
// Where the files that come with the program are: $SVCHAIN_SHARE, or ../share/svchain beside the program, or
// the folder that it was built from. Any thread.

#include <filesystem>

namespace svchain {

/// Has usecases/ and configs/ in it.
std::filesystem::path share_folder();
/// socs/, rigs/, lenses/, charts/, scenes/.
std::filesystem::path configs_folder();

}  // namespace svchain
