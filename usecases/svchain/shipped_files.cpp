#include "usecases/svchain/shipped_files.h"

#include <algorithm>
#include <system_error>

#include "links/configs_folder.h"

namespace svchain::program {

namespace fs = std::filesystem;

std::vector<std::string> shipped_names(const Shelf& shelf) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(share_folder() / shelf.folder, ignored)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path shipped_file(const Shelf& shelf, const std::string& name) {
  return share_folder() / shelf.folder / (name + ".json");
}

Result<fs::path> find_file(const Shelf& shelf, const std::string& name_or_file) {
  const auto names = shipped_names(shelf);
  if (std::find(names.begin(), names.end(), name_or_file) != names.end())
    return shipped_file(shelf, name_or_file);
  const fs::path file(name_or_file);
  std::error_code ignored;
  if (file.has_parent_path() || file.has_extension() || fs::exists(file, ignored)) return file;
  const std::string what = name_or_file.empty() ? std::string("missing: which ") + shelf.what + "?"
                                                : std::string("unknown ") + shelf.what + " \"" +
                                                      name_or_file + "\"" + did_you_mean(name_or_file, names);
  const std::string known = names.empty() ? "none are installed" : "known: " + spoken_list(names);
  return fail({}, what + " (" + known + ", or a .json file)");
}

}  // namespace svchain::program
