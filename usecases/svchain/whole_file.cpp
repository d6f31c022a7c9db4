#include "usecases/svchain/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace svchain::program {

namespace fs = std::filesystem;

namespace {

bool is_device(const fs::path& target) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

fs::path beside(const fs::path& target) {
  fs::path temporary = target;
  return temporary += "." + std::to_string(getpid()) + ".part";
}

/// What stands in the way of writing; "" for nothing.
std::string obstacle(const fs::path& path) {
  std::error_code error;
  if (path.empty()) return "expected a file name";
  const fs::path target = fs::weakly_canonical(path, error);
  if (error) return error.message();
  if (fs::is_directory(target, error)) return "it is a folder, expected a file";
  if (fs::exists(target, error) && access(target.c_str(), W_OK) != 0) return std::strerror(errno);
  if (is_device(target)) return {};
  errno = 0;
  if (!std::ofstream(beside(target))) return std::strerror(errno);
  fs::remove(beside(target), error);
  return {};
}

}  // namespace

Faults check_writable(const fs::path& path, const std::string& option) {
  const std::string why = obstacle(path);
  if (why.empty()) return {};
  return {{option, {}, {}, "\"" + path.string() + "\" cannot be written: " + why}};
}

void write_whole(const fs::path& path, const std::string& text) {
  const fs::path target = fs::weakly_canonical(path);
  const fs::path place = is_device(target) ? target : beside(target);
  std::ofstream file(place, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file && place != target) fs::rename(place, target, error);
  if (file && !error) return;
  if (place != target) fs::remove(place, error);
  throw std::runtime_error(path.string() + ": could not be written");
}

}  // namespace svchain::program
