#pragma once
// A folder that appears under its name only when everything is in it: filled beside it under a temporary
// name, then renamed. One thread.

#include <filesystem>
#include <string_view>

#include "algorithms/json/fault.h"

namespace svchain::program {

class NewFolder {
 public:
  /// What stands in the way, said of the option: no folder to make it in, or something there already that is
  /// not an empty folder. Leaves nothing behind.
  static Faults check(const std::filesystem::path& path, const std::string& option);

  /// Everything below throws std::runtime_error, naming the file, where the disk is full or gone.
  explicit NewFolder(const std::filesystem::path& path);
  /// Removes what was not kept.
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Writes a file, `name` being relative; folders on the way to it are made.
  void write(const std::filesystem::path& name, std::string_view bytes);
  /// All is there: the folder gets its name.
  void keep();

 private:
  std::filesystem::path path_, part_;
};

}  // namespace svchain::program
