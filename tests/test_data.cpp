#include "tests/test_data.h"

#include <atomic>
#include <cstdlib>
#include <string>
#include <unistd.h>

namespace svchain::testing {

namespace fs = std::filesystem;

fs::path project_folder() {
  return fs::path(SVCHAIN_SOURCE_DIR);
}

std::optional<fs::path> data_folder() {
  const char* named = std::getenv("SVCHAIN_TEST_DATA");
  const fs::path folder = named ? fs::path(named) : project_folder() / ".." / "shared" / "data";
  if (!fs::is_directory(folder)) return std::nullopt;
  return fs::canonical(folder);
}

TemporaryFolder::TemporaryFolder() {
  static std::atomic<int> count{0};
  path_ = fs::temp_directory_path() /
          ("svchain-test-" + std::to_string(getpid()) + "-" + std::to_string(count++));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace svchain::testing
