#include "ipc/shared_region.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <sys/mman.h>

#include "tests/catch.h"

using svchain::ipc::SharedRegion;

namespace {

constexpr size_t kHugePage = size_t{2} << 20;

bool system_allows_huge_pages() {
  std::string modes;
  std::getline(std::ifstream("/sys/kernel/mm/transparent_hugepage/shmem_enabled"), modes);
  return !modes.empty() && modes.find("[never]") == std::string::npos &&
         modes.find("[deny]") == std::string::npos;
}

/// Of the mapping of this name, from /proc/self/smaps.
size_t huge_kilobytes(const std::string& name) {
  std::ifstream maps("/proc/self/smaps");
  bool here = false;
  for (std::string line; std::getline(maps, line);) {
    if (line.find("memfd:") != std::string::npos) here = line.find(name) != std::string::npos;
    const std::string field = "ShmemPmdMapped:";
    if (here && line.rfind(field, 0) == 0) return std::stoul(line.substr(field.size()));
  }
  return 0;
}

}  // namespace

TEST_CASE("a shared region is zeroed and moves with its owner") {
  SharedRegion region("test", 10'000);
  REQUIRE(region.bytes().size() == 10'000);
  CHECK(region.bytes()[9'999] == std::byte{0});
  region.bytes()[0] = std::byte{42};
  SharedRegion other = std::move(region);
  CHECK(region.bytes().empty());
  CHECK(other.bytes()[0] == std::byte{42});
}

TEST_CASE("a large shared region begins at a huge page and is as long as was asked for") {
  SharedRegion region("test", 3 * kHugePage + 1);
  CHECK(region.bytes().size() == 3 * kHugePage + 1);
  CHECK(reinterpret_cast<uintptr_t>(region.bytes().data()) % kHugePage == 0);
  region.bytes().back() = std::byte{7};
  void* again = mmap(nullptr, 4 * kHugePage, PROT_READ, MAP_SHARED, region.file_descriptor(), 0);
  REQUIRE(again != MAP_FAILED);
  CHECK(static_cast<std::byte*>(again)[3 * kHugePage] == std::byte{7});
  munmap(again, 4 * kHugePage);
}

TEST_CASE("a large shared region lies in huge pages where the system allows them") {
  SharedRegion region("svchain:huge", 2 * kHugePage);
  std::memset(region.bytes().data(), 1, region.bytes().size());
  if (system_allows_huge_pages()) CHECK(huge_kilobytes("svchain:huge") == 2 * kHugePage / 1024);
}
