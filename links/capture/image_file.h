#pragma once
// Still images in files. Pure functions, any thread.

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

namespace svchain {

/// By the name's end: .png, .jpg, .jpeg or .bmp in any case.
bool is_image_name(const std::filesystem::path& path);

/// What is visibly wrong with a file from its first and last bytes, without decoding it: no such file, empty,
/// none of the formats, cut off. "" for nothing. Decoders accept cut-off JPEG and BMP files and fill up with
/// grey.
std::string image_damage(const std::filesystem::path& path);

/// Decodes into the picture, without a copy where it has the image's size already; otherwise it is given that
/// size. Throws std::runtime_error on damage, saying what but not which file.
void read_image(const std::filesystem::path& path, cv::Mat& bgr);

}  // namespace svchain
