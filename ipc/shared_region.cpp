#include "ipc/shared_region.h"

#include <cerrno>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace svchain::ipc {

namespace {

[[noreturn]] void fail(const std::string& name, size_t bytes) {
  throw std::system_error(errno, std::generic_category(),
                          "shared memory for " + name + " (" + std::to_string(bytes) + " bytes)");
}

}  // namespace

SharedRegion::SharedRegion(const std::string& name, size_t bytes) : size_(bytes) {
  descriptor_ = memfd_create(name.c_str(), MFD_CLOEXEC);
  if (descriptor_ < 0) fail(name, bytes);
  void* mapped = MAP_FAILED;
  if (ftruncate(descriptor_, static_cast<off_t>(bytes)) == 0) {
    mapped = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
  }
  if (mapped == MAP_FAILED) {
    const int error = errno;
    ::close(descriptor_);
    descriptor_ = -1;
    errno = error;
    fail(name, bytes);
  }
  data_ = static_cast<std::byte*>(mapped);
}

SharedRegion::SharedRegion(SharedRegion&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

SharedRegion& SharedRegion::operator=(SharedRegion&& other) noexcept {
  if (this != &other) {
    close();
    data_ = std::exchange(other.data_, nullptr);
    size_ = std::exchange(other.size_, 0);
    descriptor_ = std::exchange(other.descriptor_, -1);
  }
  return *this;
}

SharedRegion::~SharedRegion() {
  close();
}

void SharedRegion::close() {
  if (data_) munmap(data_, size_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace svchain::ipc
