#include "algorithms/synthesis/stored_block.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace svchain::synthesis {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "stored blocks are little-endian");

struct FileHeader {
  std::array<char, 8> magic = {};
  uint32_t version = 0;
  uint32_t header_bytes = sizeof(FileHeader);
  uint64_t block_bytes = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(FileHeader) == 32);

std::string why_not() {
  return errno ? std::strerror(errno) : "the disk took less than all of it";
}

/// What is wrong with the file as a file; "" for nothing. `block` is its content behind the header.
std::string damage(const StoredFormat& format, const FileHeader& header, uint64_t file_bytes,
                   std::span<const std::byte> block) {
  const std::string bytes = std::to_string(file_bytes) + " bytes long";
  if (file_bytes < sizeof(FileHeader) || header.magic != format.magic)
    return "is no " + format.name + " file, expected one that was stored by " + format.stored_by;
  if (header.version != format.version) {
    return "is a " + format.name + " file of version " + std::to_string(header.version) + ", expected " +
           std::to_string(format.version);
  }
  if (block.size() != header.block_bytes) {
    return "is " + bytes + ", expected " + std::to_string(sizeof(FileHeader) + header.block_bytes) +
           (block.size() < header.block_bytes ? ": it was cut short" : "");
  }
  if (fnv1a(block) != header.checksum) return "is damaged: its checksum is not that of its content";
  return "";
}

}  // namespace

uint64_t fnv1a(std::span<const std::byte> bytes) {
  uint64_t hash = 14695981039346656037u;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<uint64_t>(b)) * 1099511628211u;
  return hash;
}

void write_block(const fs::path& path, const StoredFormat& format, std::span<const std::byte> block) {
  FileHeader header;
  header.magic = format.magic;
  header.version = format.version;
  header.block_bytes = block.size();
  header.checksum = fnv1a(block);
  fs::path part = path;
  part += "." + std::to_string(getpid()) + ".part";
  errno = 0;
  std::ofstream file(part, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&header), sizeof(header));
  file.write(reinterpret_cast<const char*>(block.data()), static_cast<std::streamsize>(block.size()));
  file.close();
  std::string why = file ? "" : why_not();
  std::error_code failed;
  if (file) fs::rename(part, path, failed);
  if (failed) why = failed.message();
  if (why.empty()) return;
  fs::remove(part, failed);
  throw std::runtime_error(path.string() + ": the " + format.name + " could not be written: " + why);
}

Result<std::vector<std::byte>> read_block(const fs::path& path, const StoredFormat& format) {
  const std::string name = path.string();
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return fail(name, "is a folder, expected a " + format.name + " file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(name, "cannot be read: " + std::string(std::strerror(errno)));

  FileHeader header;
  file.read(reinterpret_cast<char*>(&header), sizeof(header));
  const auto header_bytes = static_cast<uint64_t>(file.gcount());
  std::vector<std::byte> block;
  if (file && header.magic == format.magic) {
    block.resize(fs::file_size(path) - sizeof(header));
    file.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>(block.size()));
  }
  if (const std::string what = damage(format, header, header_bytes + block.size(), block); !what.empty())
    return fail(name, what);
  return block;
}

}  // namespace svchain::synthesis
