#include "usecases/svchain/new_folder.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace svchain::program {

namespace fs = std::filesystem;

namespace {

/// Absolute, links followed, without a slash at its end.
fs::path resolved(const fs::path& path) {
  std::error_code failed;
  const fs::path absolute = fs::weakly_canonical(fs::absolute(path), failed);
  if (failed) return path;
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

std::string obstacle(const fs::path& given) {
  if (given.empty()) return "expected a folder";
  const std::string name = "\"" + given.string() + "\"";
  const fs::path path = resolved(given);
  std::error_code failed;
  if (fs::exists(path, failed)) {
    if (!fs::is_directory(path, failed)) return name + " is a file, expected a folder";
    if (!fs::is_empty(path, failed) || failed) return name + " is not empty, expected a new or empty folder";
  }
  const fs::path parent = path.parent_path();
  if (!fs::is_directory(parent, failed))
    return name + " cannot be made: there is no folder " + parent.string();
  if (access(parent.c_str(), W_OK | X_OK) != 0) return name + " cannot be made: " + std::strerror(errno);
  return {};
}

[[noreturn]] void give_up(const fs::path& path) {
  throw std::runtime_error(path.string() + ": could not be written");
}

}  // namespace

Faults NewFolder::check(const fs::path& path, const std::string& option) {
  const std::string why = obstacle(path);
  if (why.empty()) return {};
  return {{option, {}, {}, why}};
}

NewFolder::NewFolder(const fs::path& path) : path_(resolved(path)), part_(path_) {
  part_ += "." + std::to_string(getpid()) + ".part";
  std::error_code failed;
  if (!fs::create_directory(part_, failed)) give_up(path_);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!part_.empty()) fs::remove_all(part_, ignored);
}

void NewFolder::write(const fs::path& name, std::string_view bytes) {
  std::error_code failed;
  fs::create_directories((part_ / name).parent_path(), failed);
  std::ofstream file(part_ / name, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) give_up(path_ / name);
}

void NewFolder::keep() {
  std::error_code failed;
  fs::rename(part_, path_, failed);
  if (failed) give_up(path_);
  part_.clear();
}

}  // namespace svchain::program
