#include "links/configs_folder.h"

#include <cstdlib>
#include <system_error>

namespace svchain {

namespace fs = std::filesystem;

fs::path share_folder() {
  if (const char* named = std::getenv("SVCHAIN_SHARE")) return named;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / "share" / "svchain";
  if (fs::is_directory(installed, ignored)) return installed;
  return SVCHAIN_SOURCE_DIR;
}

fs::path configs_folder() {
  return share_folder() / "configs";
}

}  // namespace svchain
