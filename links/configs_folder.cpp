#include "links/configs_folder.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

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

namespace {

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    if (at->path().extension() == ".json") names.push_back(at->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

Result<fs::path> find_config(const std::string& folder, const std::string& what, const std::string& named) {
  std::error_code ignored;
  const fs::path shelf = configs_folder() / folder;
  const fs::path shipped = shelf / (named + ".json");
  if (!named.empty() && fs::is_regular_file(shipped, ignored)) return shipped;
  if (fs::is_regular_file(named, ignored)) return fs::path(named);
  const std::vector<std::string> names = names_in(shelf);
  return fail(named, "no such " + what + " or file" + did_you_mean(named, names) + "; there is " +
                         (names.empty() ? "none in " + shelf.string() : spoken_list(names)));
}

}  // namespace svchain
