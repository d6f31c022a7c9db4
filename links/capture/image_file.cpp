#include "links/capture/image_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace svchain {

namespace fs = std::filesystem;

namespace {

using namespace std::string_view_literals;

constexpr auto kPngHead = "\x89PNG\r\n\x1a\n"sv;
constexpr auto kPngEnd = "IEND\xae\x42\x60\x82"sv;
constexpr auto kJpegHead = "\xff\xd8\xff"sv;
constexpr auto kJpegEnd = "\xff\xd9"sv;
constexpr std::streamoff kLongestTail = 1 << 16;  // cameras append maker's data behind the image

std::string read_at(std::ifstream& file, std::streamoff offset, std::streamoff bytes) {
  std::string text(static_cast<size_t>(std::max<std::streamoff>(bytes, 0)), '\0');
  file.clear();
  file.seekg(offset);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(file.gcount()));
  return text;
}

uint32_t little_endian(std::string_view bytes) {
  uint32_t value = 0;
  for (size_t i = 4; i-- > 0;) value = value << 8 | static_cast<uint8_t>(bytes[i]);
  return value;
}

bool ends_with_mark(std::ifstream& file, std::streamoff first, std::streamoff size, std::string_view mark) {
  const std::streamoff from = std::max(first, size - kLongestTail);
  return read_at(file, from, size - from).find(mark) != std::string::npos;
}

/// Where the compressed data of a JPEG begin: behind its headers, whose thumbnails have end marks of their
/// own.
std::optional<std::streamoff> jpeg_scan(std::ifstream& file, std::streamoff size) {
  for (std::streamoff at = 2; at + 4 <= size;) {
    const std::string head = read_at(file, at, 4);
    if (head.size() < 4 || head[0] != '\xff') return std::nullopt;
    const int length = static_cast<uint8_t>(head[2]) << 8 | static_cast<uint8_t>(head[3]);
    if (head[1] == '\xda') return at + 2 + length;
    at += 2 + length;
  }
  return std::nullopt;
}

bool bmp_is_complete(std::ifstream& file, std::streamoff size) {
  const std::string head = read_at(file, 0, 34);
  if (head.size() < 34) return false;
  const std::string_view view = head;
  const std::streamoff pixels_at = little_endian(view.substr(10));
  const std::streamoff width = static_cast<int32_t>(little_endian(view.substr(18)));
  const std::streamoff height = std::abs(static_cast<int32_t>(little_endian(view.substr(22))));
  const std::streamoff bits = static_cast<uint8_t>(head[28]) | static_cast<uint8_t>(head[29]) << 8;
  const uint32_t compression = little_endian(view.substr(30));
  if (compression != 0 && compression != 3) return little_endian(view.substr(2)) <= size;
  return pixels_at + (width * bits + 31) / 32 * 4 * height <= size;
}

}  // namespace

bool is_image_name(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array kKnown = {".png", ".jpg", ".jpeg", ".bmp"};
  return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

std::string image_damage(const fs::path& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return "cannot be opened: " + std::string(std::strerror(errno));
  const std::streamoff size = file.tellg();
  if (size == 0) return "is empty";
  const std::string head = read_at(file, 0, 8);
  bool complete = false;
  if (head.starts_with(kPngHead)) {
    complete = ends_with_mark(file, 0, size, kPngEnd);
  } else if (head.starts_with(kJpegHead)) {
    const auto scan = jpeg_scan(file, size);
    complete = scan && ends_with_mark(file, *scan, size, kJpegEnd);
  } else if (head.starts_with("BM")) {
    complete = bmp_is_complete(file, size);
  } else {
    return "holds no PNG, JPEG or BMP image";
  }
  return complete ? "" : "is cut off after " + std::to_string(size) + " bytes";
}

void read_image(const fs::path& path, cv::Mat& bgr) {
  if (const std::string damage = image_damage(path); !damage.empty()) throw std::runtime_error(damage);
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<char> bytes(static_cast<size_t>(file.tellg()));
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8U, bytes.data());
  cv::Mat image = bgr;
  try {
    cv::imdecode(encoded, cv::IMREAD_COLOR, &image);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) throw std::runtime_error("is damaged: it cannot be decoded");
  if (image.size() == bgr.size() && image.data != bgr.data) {
    image.copyTo(bgr);
  } else {
    bgr = image;
  }
}

}  // namespace svchain
