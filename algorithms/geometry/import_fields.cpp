#include "algorithms/geometry/import_fields.h"

#include "algorithms/geometry/camera_files.h"

namespace svchain::geometry {

namespace {

constexpr json::Range kImageSizePx{16, 16384};

}  // namespace

Eigen::Vector2i image_size(const json::Value& list) {
  const auto items = list.items(2);
  if (items.empty()) return {0, 0};
  return image_size(items[0], items[1]);
}

Eigen::Vector2i image_size(const json::Value& width, const json::Value& height) {
  return {static_cast<int>(width.integer(kImageSizePx)), static_cast<int>(height.integer(kImageSizePx))};
}

Result<Rig> import_camera_files(const std::vector<std::filesystem::path>& files, const Rig& nominal,
                                const std::function<Faults(const std::filesystem::path&, Camera&)>& read) {
  const auto of_camera = camera_files(files);
  if (!of_camera) return tl::unexpected(of_camera.error());
  Rig rig = nominal;
  Faults faults;
  for (size_t i = 0; i < rig.cameras.size(); ++i) {
    const Faults more = read((*of_camera)[i], rig.cameras[i]);
    faults.insert(faults.end(), more.begin(), more.end());
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return rig;
}

}  // namespace svchain::geometry
