#include "usecases/svchain/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace svchain::program {

namespace fs = std::filesystem;

Result<WholeFile> WholeFile::create(const fs::path& path, const std::string& option) {
  const auto bad = [&](const std::string& why) {
    return fail(option, "\"" + path.string() + "\" cannot be written: " + why);
  };
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);  // a link is written through, not replaced
  if (error || path.empty()) return bad(error ? error.message() : "expected a file");
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) return bad("it is a folder, expected a file");
  const bool regular = fs::is_regular_file(status) || !fs::exists(status);
  if (regular && fs::exists(status) && access(target.c_str(), W_OK) != 0) return bad(std::strerror(errno));

  fs::path place = target;
  if (regular) place += "." + std::to_string(getpid()) + ".part";
  errno = 0;
  if (!std::ofstream(place, std::ios::app)) return bad(std::strerror(errno));
  return WholeFile(target, place);
}

WholeFile::WholeFile(fs::path path, fs::path temporary)
    : path_(std::move(path)), temporary_(std::move(temporary)) {}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})) {}

WholeFile::~WholeFile() {
  std::error_code ignored;
  if (!temporary_.empty() && temporary_ != path_) fs::remove(temporary_, ignored);
}

void WholeFile::write(const std::string& text) {
  std::ofstream file(temporary_, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path_.string() + ": could not be written");
  if (temporary_ != path_) fs::rename(temporary_, path_);
  temporary_.clear();
}

}  // namespace svchain::program
