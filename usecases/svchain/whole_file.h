#pragma once
// A text file that appears under its name only when it is whole: written beside it under a temporary name,
// then renamed. What is no regular file (a pipe, a device) is written as it stands. One thread.

#include <filesystem>
#include <string>

#include "algorithms/json/fault.h"

namespace svchain::program {

class WholeFile {
 public:
  /// Finds out whether the file can be written. `option` is what a fault is said of: "--report".
  static Result<WholeFile> create(const std::filesystem::path& path, const std::string& option);
  /// Leaves nothing behind unless the text was written.
  ~WholeFile();
  WholeFile(WholeFile&& other) noexcept;
  WholeFile& operator=(WholeFile&&) = delete;

  /// Throws std::runtime_error, naming the file, where the disk is full or gone.
  void write(const std::string& text);

 private:
  WholeFile(std::filesystem::path path, std::filesystem::path temporary);
  std::filesystem::path path_;
  std::filesystem::path temporary_;  // empty once it has got its name
};

}  // namespace svchain::program
