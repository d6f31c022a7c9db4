#pragma once
// Small things to feed the program with: a use case to change, four small cameras, and images for them.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>

#include "tests/program/program.h"

namespace svchain::testing {

using Json = nlohmann::ordered_json;

inline const std::vector<std::string> kCameras = {"front", "right", "rear", "left"};

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);
inline void write_json(const std::filesystem::path& path, const Json& json) {
  write_text(path, json.dump(1));
}

/// A use case that is shipped, to be changed.
Json shipped_use_case(const std::string& name);

/// Four cameras of 320 x 180 px on a car.
Json small_rig();

/// What such a camera sees: something else in every camera and every frame.
cv::Mat small_image(size_t camera, int frame = 0);
void write_stills(const std::filesystem::path& folder);
void write_numbered(const std::filesystem::path& folder, int frames);

/// The shipped car park on coarser ground, seen by cameras of 640 x 360 px that are all alike: its file, with
/// its rig beside it.
std::filesystem::path small_scene_file(const std::filesystem::path& folder);

/// "--usecase USECASE --rig ... --input ..." and a small view.
Arguments small_run(const std::string& use_case, const std::filesystem::path& rig,
                    const std::filesystem::path& input, const Arguments& more = {});

/// Files and folders in a folder.
size_t count_of(const std::filesystem::path& folder);

}  // namespace svchain::testing
