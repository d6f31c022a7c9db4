#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/calibration/print_charts.h"

namespace svchain::calibration {

namespace {

constexpr double kLongestSidePx = 12000;

/// A whole number of pixels to the metre, so that round lengths begin and end at pixels.
double px_per_metre(const Sheet& sheet) {
  double density = 10000;
  for (const double next : {5000, 2000, 1000, 500, 200, 100, 50, 20, 10}) {
    if (sheet.size_m.maxCoeff() * density > kLongestSidePx) density = next;
  }
  return density;
}

std::string big_endian(uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

/// As PNG's chunks end with (ISO 15948, annex D).
uint32_t crc32(const std::string& bytes) {
  uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320 : 0);
  }
  return ~crc;
}

/// The chunk that says how large a pixel is.
std::string density_chunk(double density) {
  const auto per_metre = static_cast<uint32_t>(density);
  constexpr char kMetre = 1;
  const std::string typed = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + kMetre;
  return big_endian(9) + typed + big_endian(crc32(typed));
}

/// Fills the pixels whose centres lie in the polygon: four corners are an upright rectangle, which is filled
/// to the pixel, others are as OpenCV draws them.
void fill(const std::vector<Eigen::Vector2d>& polygon, double density, cv::Mat& picture) {
  std::vector<cv::Point> corners;
  corners.reserve(polygon.size());
  for (const auto& corner : polygon) {
    corners.emplace_back(static_cast<int>(std::lround(corner.x() * density)),
                         picture.rows - static_cast<int>(std::lround(corner.y() * density)));
  }
  if (corners.size() == 4)
    picture(cv::Rect(corners[0], corners[2])).setTo(0);  // lower left and upper right
  else
    cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{corners}, 0);
}

void write(const Label& label, double density, cv::Mat& picture) {
  constexpr double kFontPx = 30;  // of OpenCV's letters at scale 1
  const double height_px = label.height_m * density;
  const cv::Point place(static_cast<int>(label.place_m.x() * density),
                        picture.rows - static_cast<int>(label.place_m.y() * density));
  cv::putText(picture, label.text, place, cv::FONT_HERSHEY_SIMPLEX, height_px / kFontPx, 0,
              std::max(1, static_cast<int>(height_px / 12)));
}

}  // namespace

std::string png_of(const Sheet& sheet) {
  const double density = px_per_metre(sheet);
  const auto px = [&](double metres) { return std::max(1, static_cast<int>(std::lround(metres * density))); };
  cv::Mat picture(px(sheet.size_m.y()), px(sheet.size_m.x()), CV_8U, 255);
  for (const auto& polygon : sheet.black) fill(polygon, density, picture);
  for (const auto& label : sheet.labels) write(label, density, picture);
  std::vector<uint8_t> bytes;
  cv::imencode(".png", picture, bytes, {cv::IMWRITE_PNG_BILEVEL, 1});
  std::string text(bytes.begin(), bytes.end());
  constexpr size_t kAfterHeader = 8 + 25;  // signature, header chunk
  return text.insert(kAfterHeader, density_chunk(density));
}

}  // namespace svchain::calibration
