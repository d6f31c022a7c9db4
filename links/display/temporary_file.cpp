#include "links/display/temporary_file.h"

#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

namespace svchain {

namespace fs = std::filesystem;

TemporaryFile::TemporaryFile(fs::path target) : target_(std::move(target)) {
  const std::string name = "." + target_.stem().string() + "." + std::to_string(getpid()) + ".part";
  path_ = target_.parent_path() / (name + target_.extension().string());
}

TemporaryFile::~TemporaryFile() {
  remove();
}

void TemporaryFile::keep() {
  std::error_code failed;
  fs::rename(path_, target_, failed);
  if (failed) throw std::runtime_error(target_.string() + " cannot be written: " + failed.message());
}

void TemporaryFile::remove() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace svchain
