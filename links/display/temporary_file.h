#pragma once
// A file under another name in the same folder, which gets its own name when it is complete, and is removed
// otherwise.

#include <filesystem>

namespace svchain {

class TemporaryFile {
 public:
  /// Only thinks of a name: what it stands for is written by others. It keeps the target's extension.
  explicit TemporaryFile(std::filesystem::path target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& target() const { return target_; }
  /// Replaces the target. Throws std::runtime_error that names it.
  void keep();
  void remove();

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
};

}  // namespace svchain
