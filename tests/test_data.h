#pragma once
// Where tests find things that are not code.

#include <filesystem>
#include <optional>

namespace svchain::testing {

/// The project's own folder.
std::filesystem::path project_folder();

/// Real recordings: $SVCHAIN_TEST_DATA, or ../shared/data beside the project. Nothing where they are absent.
std::optional<std::filesystem::path> data_folder();

/// A fresh empty folder, removed with everything in it when the object goes.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace svchain::testing
