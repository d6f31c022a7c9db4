#pragma once
// A block of bytes on disk that outlives a power-down and is not taken for what it is not: a header of 32
// bytes (magic, version of the file format, length and FNV-1a 64 of what follows), then the block,
// little-endian. Functions may be called from any thread.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "algorithms/json/fault.h"

namespace svchain::synthesis {

struct StoredFormat {
  std::array<char, 8> magic;
  uint32_t version;
  std::string name;       // what messages call the block: "LUT"
  std::string stored_by;  // who writes such files
};

uint64_t fnv1a(std::span<const std::byte> bytes);

/// Writes a block, the file being there whole or not at all: it gets its name when it is complete. Throws
/// std::runtime_error that names the path.
void write_block(const std::filesystem::path& path, const StoredFormat& format,
                 std::span<const std::byte> block);

/// The block of a file. Faults name the file: it cannot be read, is of another format or version, cut short
/// or damaged.
Result<std::vector<std::byte>> read_block(const std::filesystem::path& path, const StoredFormat& format);

}  // namespace svchain::synthesis
