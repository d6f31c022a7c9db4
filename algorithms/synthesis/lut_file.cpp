#include "algorithms/synthesis/lut_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "LUT files are little-endian");

constexpr std::array<char, 8> kMagic = {'S', 'V', 'C', 'H', 'L', 'U', 'T', '\n'};
constexpr uint32_t kFileVersion = 1;

struct FileHeader {
  std::array<char, 8> magic = kMagic;
  uint32_t version = kFileVersion;
  uint32_t header_bytes = sizeof(FileHeader);
  uint64_t lut_bytes = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(FileHeader) == 32);

uint64_t fnv1a(std::span<const std::byte> bytes) {
  uint64_t hash = 14695981039346656037u;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<uint64_t>(b)) * 1099511628211u;
  return hash;
}

std::string why_not() {
  return errno ? std::strerror(errno) : "the disk took less than all of it";
}

/// What is wrong with the file as a file; "" for nothing. `lut` is its content behind the header.
std::string damage(const FileHeader& header, uint64_t file_bytes, std::span<const std::byte> lut) {
  const std::string bytes = std::to_string(file_bytes) + " bytes long";
  if (file_bytes < sizeof(FileHeader) || header.magic != kMagic)
    return "is no LUT file, expected one that was stored by geometric alignment";
  if (header.version != kFileVersion) {
    return "is a LUT file of version " + std::to_string(header.version) + ", expected " +
           std::to_string(kFileVersion);
  }
  if (lut.size() != header.lut_bytes) {
    return "is " + bytes + ", expected " + std::to_string(sizeof(FileHeader) + header.lut_bytes) +
           (lut.size() < header.lut_bytes ? ": it was cut short" : "");
  }
  if (fnv1a(lut) != header.checksum) return "is damaged: its checksum is not that of its content";
  return "";
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " px";
}

bool alike(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

/// Everything in which a LUT is not one for this use.
class Differences {
 public:
  Differences(std::string file, const LutHeader& header) : file_(std::move(file)), header_(header) {}

  void of_view(const geometry::View& view) {
    if (header_.width != view.size_px.x() || header_.height != view.size_px.y()) {
      add("its view is " + size_text(header_.width, header_.height),
          size_text(view.size_px.x(), view.size_px.y()));
    }
    if (!alike(header_.metres_per_px, view.metres_per_px))
      add("its view has " + number(header_.metres_per_px) + " m a pixel", number(view.metres_per_px));
    const double* centre = header_.centre_m;
    if (!alike(centre[0], view.centre_m.x()) || !alike(centre[1], view.centre_m.y())) {
      add("the centre of its view is " + number(centre[0]) + ", " + number(centre[1]) + " m",
          number(view.centre_m.x()) + ", " + number(view.centre_m.y()));
    }
  }

  void of_cameras(const geometry::Rig& rig) {
    for (size_t i = 0; i < rig.cameras.size() && i < header_.image_size_px.size(); ++i) {
      const auto [width, height] = header_.image_size_px[i];
      const Eigen::Vector2i& size = rig.cameras[i].image_size_px;
      if (width == size.x() && height == size.y()) continue;
      add("its pictures of camera " + rig.cameras[i].name + " are " + size_text(width, height),
          size_text(size.x(), size.y()));
    }
  }

  Faults faults;

 private:
  static std::string number(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
  }
  void add(const std::string& what, const std::string& expected) {
    faults.push_back({file_, {}, {}, what + ", expected " + expected});
  }

  std::string file_;
  const LutHeader& header_;
};

}  // namespace

void write_lut_file(const fs::path& path, std::span<const std::byte> lut) {
  FileHeader header;
  header.lut_bytes = lut.size();
  header.checksum = fnv1a(lut);
  fs::path part = path;
  part += "." + std::to_string(getpid()) + ".part";
  errno = 0;
  std::ofstream file(part, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&header), sizeof(header));
  file.write(reinterpret_cast<const char*>(lut.data()), static_cast<std::streamsize>(lut.size()));
  file.close();
  std::string why = file ? "" : why_not();
  std::error_code failed;
  if (file) fs::rename(part, path, failed);
  if (failed) why = failed.message();
  if (why.empty()) return;
  fs::remove(part, failed);
  throw std::runtime_error(path.string() + ": the LUT could not be written: " + why);
}

Result<std::vector<std::byte>> read_lut_file(const fs::path& path, const geometry::Rig& rig,
                                             const geometry::View& view) {
  const std::string name = path.string();
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return fail(name, "is a folder, expected a LUT file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(name, "cannot be read: " + std::string(std::strerror(errno)));

  FileHeader header;
  file.read(reinterpret_cast<char*>(&header), sizeof(header));
  const auto header_bytes = static_cast<uint64_t>(file.gcount());
  std::vector<std::byte> lut;
  if (file && header.magic == kMagic) {
    lut.resize(fs::file_size(path) - sizeof(header));
    file.read(reinterpret_cast<char*>(lut.data()), static_cast<std::streamsize>(lut.size()));
  }
  if (const std::string what = damage(header, header_bytes + lut.size(), lut); !what.empty())
    return fail(name, what);
  try {
    Differences differences(name, GeometricLut(lut).header());
    differences.of_view(view);
    differences.of_cameras(rig);
    if (!differences.faults.empty()) return tl::unexpected(std::move(differences.faults));
  } catch (const std::invalid_argument& error) {
    return fail(name, error.what());
  }
  return lut;
}

}  // namespace svchain::synthesis
