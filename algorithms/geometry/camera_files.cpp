#include "algorithms/geometry/camera_files.h"

#include <algorithm>
#include <cctype>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

namespace {

bool names(const std::filesystem::path& file, const std::string& camera) {
  std::string stem = file.stem().string();
  std::transform(stem.begin(), stem.end(), stem.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto holds = [&](const std::string& word) { return stem.find(word) != std::string::npos; };
  return holds(camera) || (camera == "rear" && holds("back"));
}

}  // namespace

Result<std::array<std::filesystem::path, 4>> camera_files(const std::vector<std::filesystem::path>& files) {
  std::array<std::filesystem::path, 4> of_camera;
  Faults faults;
  for (const auto& file : files) {
    std::vector<size_t> named;
    for (size_t i = 0; i < kCameraNames.size(); ++i) {
      if (names(file, kCameraNames[i])) named.push_back(i);
    }
    if (named.size() != 1) {
      faults.push_back(
          {file.string(), {}, {}, "the name must tell one camera: front, right, rear (or back), left"});
    } else if (auto& taken = of_camera[named.front()]; !taken.empty()) {
      faults.push_back(
          {file.string(),
           {},
           {},
           "a second file of the " + kCameraNames[named.front()] + " camera, after " + taken.string()});
    } else {
      taken = file;
    }
  }
  for (size_t i = 0; i < kCameraNames.size(); ++i) {
    if (!of_camera[i].empty()) continue;
    faults.push_back({{},
                      {},
                      {},
                      "no file of the " + kCameraNames[i] + " camera among the " +
                          std::to_string(files.size()) + " given"});
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return of_camera;
}

}  // namespace svchain::geometry
