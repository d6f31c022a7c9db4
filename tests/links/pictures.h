#pragma once
// Small pictures, folders and videos for tests of links.

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

#include "algorithms/json/fault.h"

namespace svchain::testing {

/// A picture that tells which one it is: every pixel is (camera, number, column).
cv::Mat numbered_picture(int camera, int number, cv::Size size = {8, 6});

void write_picture(const std::filesystem::path& file, const cv::Mat& picture);
/// FFV1, lossless.
void write_video(const std::filesystem::path& file, int camera, int frames, cv::Size size = {8, 6});
/// front.png, right.png, rear.png, left.png.
void write_stills(const std::filesystem::path& folder, cv::Size size = {8, 6});
/// front/000000.png and so on.
void write_numbered(const std::filesystem::path& folder, int frames);
/// A file's last bytes are lost.
void cut_off(const std::filesystem::path& file, double share = 0.5);

/// All faults, one a line.
std::string text_of(const Faults& faults);

}  // namespace svchain::testing
