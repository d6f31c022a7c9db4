#pragma once
// Text files that appear under their names only when they are whole: written beside them under a temporary
// name, then renamed. What is no regular file (a pipe, a device) is written as it stands; links are written
// through.

#include <filesystem>
#include <string>

#include "algorithms/json/fault.h"

namespace svchain::program {

/// Finds out beforehand whether the file can be written, and leaves nothing behind. `option` is what a fault
/// is said of.
Faults check_writable(const std::filesystem::path& path, const std::string& option);

/// Throws std::runtime_error, naming the file, where the disk is full or gone.
void write_whole(const std::filesystem::path& path, const std::string& text);

}  // namespace svchain::program
