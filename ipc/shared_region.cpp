#include "ipc/shared_region.h"

#include <cerrno>
#include <cstdint>
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

constexpr size_t kHugePage = size_t{2} << 20;

size_t rounded_up(size_t bytes) {
  return (bytes + kHugePage - 1) / kHugePage * kHugePage;
}

/// Whole huge pages are placed where such pages can lie: in more address space than is needed, whose ends are
/// given back. MAP_FAILED as mmap says it.
void* map(int descriptor, size_t bytes) {
  if (bytes < kHugePage) return mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  void* const reserved = mmap(nullptr, bytes + kHugePage, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (reserved == MAP_FAILED) return MAP_FAILED;
  std::byte* const begin = static_cast<std::byte*>(reserved);
  const size_t before = rounded_up(reinterpret_cast<uintptr_t>(begin)) - reinterpret_cast<uintptr_t>(begin);
  if (before > 0) munmap(begin, before);
  munmap(begin + before + bytes, kHugePage - before);
  void* const mapped =
      mmap(begin + before, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, descriptor, 0);
  if (mapped == MAP_FAILED)
    munmap(begin + before, bytes);
  else
    madvise(mapped, bytes, MADV_HUGEPAGE);  // where it is not allowed, pages stay small
  return mapped;
}

}  // namespace

SharedRegion::SharedRegion(const std::string& name, size_t bytes)
    : size_(bytes), mapped_(bytes < kHugePage ? bytes : rounded_up(bytes)) {
  descriptor_ = memfd_create(name.c_str(), MFD_CLOEXEC);
  if (descriptor_ < 0) fail(name, bytes);
  void* mapped = MAP_FAILED;
  if (ftruncate(descriptor_, static_cast<off_t>(mapped_)) == 0) mapped = map(descriptor_, mapped_);
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
      mapped_(std::exchange(other.mapped_, 0)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

SharedRegion& SharedRegion::operator=(SharedRegion&& other) noexcept {
  if (this != &other) {
    close();
    data_ = std::exchange(other.data_, nullptr);
    size_ = std::exchange(other.size_, 0);
    mapped_ = std::exchange(other.mapped_, 0);
    descriptor_ = std::exchange(other.descriptor_, -1);
  }
  return *this;
}

SharedRegion::~SharedRegion() {
  close();
}

void SharedRegion::close() {
  if (data_) munmap(data_, mapped_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace svchain::ipc
