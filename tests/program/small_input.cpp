#include "tests/program/small_input.h"

#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "tests/test_data.h"

namespace svchain::testing {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

Json shipped_use_case(const std::string& name) {
  return Json::parse(read_text(project_folder() / "usecases" / (name + ".json")));
}

Json small_rig() {
  Json rig = Json::parse(read_text(project_folder() / "configs" / "rigs" / "car.json"));
  rig.erase("$schema");
  for (auto& [name, camera] : rig["cameras"].items()) {
    camera["image_size_px"] = {320, 180};
    camera["lens"]["focal_px"] = {82.5, 82.5};
    camera["lens"]["centre_px"] = {159.5, 89.5};
  }
  return rig;
}

cv::Mat small_image(size_t camera, int frame) {
  cv::Mat image(180, 320, CV_8UC3, cv::Scalar(80 + 20 * static_cast<double>(camera), 120, 100));
  for (int i = 0; i < 12; ++i) {
    const int x = (37 * i + 11 * frame + 53 * static_cast<int>(camera)) % 320;
    const int y = (29 * i + 7 * frame) % 180;
    cv::circle(image, {x, y}, 14, cv::Scalar(20 * i, 255 - 20 * i, (60 * i) % 255), cv::FILLED);
  }
  return image;
}

void write_stills(const fs::path& folder) {
  fs::create_directories(folder);
  for (size_t c = 0; c < kCameras.size(); ++c) cv::imwrite(folder / (kCameras[c] + ".png"), small_image(c));
}

void write_numbered(const fs::path& folder, int frames) {
  for (size_t c = 0; c < kCameras.size(); ++c) {
    fs::create_directories(folder / kCameras[c]);
    for (int n = 0; n < frames; ++n) {
      char name[32];
      std::snprintf(name, sizeof name, "%06d.png", n);
      cv::imwrite(folder / kCameras[c] / name, small_image(c, n));
    }
  }
}

fs::path small_scene_file(const fs::path& folder) {
  Json rig = small_rig();
  for (auto& [name, camera] : rig["cameras"].items()) {
    camera["image_size_px"] = {640, 360};
    camera["lens"]["focal_px"] = {165, 165};
    camera["lens"]["centre_px"] = {319.5, 179.5};
  }
  write_json(folder / "rig.json", rig);
  Json scene = Json::parse(read_text(project_folder() / "configs" / "scenes" / "parking.json"));
  scene.erase("cameras");
  scene.erase("$schema");
  scene["rig"] = "rig.json";
  scene["ground"]["metres_per_texel"] = 0.01;
  scene["ground"]["half_extent_m"] = 6.4;
  write_json(folder / "scene.json", scene);
  return folder / "scene.json";
}

Arguments small_run(const std::string& use_case, const fs::path& rig, const fs::path& input,
                    const Arguments& more) {
  Arguments arguments = {"--usecase", use_case, "--rig", rig,
                         "--input",   input,    "--set", "view.size_px=[220,270]"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

size_t count_of(const fs::path& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace svchain::testing
