#pragma once
// A piece of memory that several processes can map: an anonymous file, zeroed, page-aligned, never on disk.
// From 2 MB it lies in huge pages, where the system allows them for shared memory
// (/sys/kernel/mm/transparent_hugepage/shmem_enabled: "advise" is enough): picture rows are as far apart as
// small pages, so kernels that walk down a picture need one for every row. Owns the mapping; move-only.
// Nothing inside may be a pointer.

#include <cstddef>
#include <span>
#include <string>

namespace svchain::ipc {

class SharedRegion {
 public:
  SharedRegion() = default;
  /// Throws std::system_error where the system gives no memory. `name` shows up in /proc/PID/maps.
  SharedRegion(const std::string& name, size_t bytes);
  SharedRegion(SharedRegion&& other) noexcept;
  SharedRegion& operator=(SharedRegion&& other) noexcept;
  ~SharedRegion();

  std::span<std::byte> bytes() const { return {data_, size_}; }
  /// To be handed to another process, which maps the same memory.
  int file_descriptor() const { return descriptor_; }

 private:
  void close();
  std::byte* data_ = nullptr;
  size_t size_ = 0;    // asked for
  size_t mapped_ = 0;  // whole huge pages, or as asked for
  int descriptor_ = -1;
};

}  // namespace svchain::ipc
