#include "algorithms/synthesis/lut_file.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/stored_block.h"

namespace svchain::synthesis {

namespace fs = std::filesystem;

namespace {

const StoredFormat kFormat = {{'S', 'V', 'C', 'H', 'L', 'U', 'T', '\n'}, 1, "LUT", "geometric alignment"};

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
  write_block(path, kFormat, lut);
}

Result<std::vector<std::byte>> read_lut_file(const fs::path& path, const geometry::Rig& rig,
                                             const geometry::View& view) {
  auto lut = read_block(path, kFormat);
  if (!lut) return lut;
  try {
    Differences differences(path.string(), GeometricLut(*lut).header());
    differences.of_view(view);
    differences.of_cameras(rig);
    if (!differences.faults.empty()) return tl::unexpected(std::move(differences.faults));
  } catch (const std::invalid_argument& error) {
    return fail(path.string(), error.what());
  }
  return lut;
}

}  // namespace svchain::synthesis
