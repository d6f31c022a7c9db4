#include "tests/links/pictures.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "algorithms/geometry/rig.h"

namespace svchain::testing {

namespace fs = std::filesystem;

cv::Mat numbered_picture(int camera, int number, cv::Size size) {
  cv::Mat picture(size, CV_8UC3);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      picture.at<cv::Vec3b>(y, x) =
          cv::Vec3b(static_cast<uchar>(camera), static_cast<uchar>(number), static_cast<uchar>(x));
    }
  }
  return picture;
}

void write_picture(const fs::path& file, const cv::Mat& picture) {
  fs::create_directories(file.parent_path());
  if (!cv::imwrite(file.string(), picture)) throw std::runtime_error("cannot write " + file.string());
}

void write_video(const fs::path& file, int camera, int frames, cv::Size size) {
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 25,
                         size);
  if (!writer.isOpened()) throw std::runtime_error("cannot write " + file.string());
  for (int n = 0; n < frames; ++n) writer.write(numbered_picture(camera, n, size));
}

void write_stills(const fs::path& folder, cv::Size size) {
  for (int c = 0; c < 4; ++c) {
    write_picture(folder / (geometry::kCameraNames[static_cast<size_t>(c)] + ".png"),
                  numbered_picture(c, 0, size));
  }
}

void write_numbered(const fs::path& folder, int frames) {
  for (int c = 0; c < 4; ++c) {
    for (int n = 0; n < frames; ++n) {
      const std::string name = std::to_string(1000000 + n).substr(1) + ".png";
      write_picture(folder / geometry::kCameraNames[static_cast<size_t>(c)] / name, numbered_picture(c, n));
    }
  }
}

void cut_off(const fs::path& file, double share) {
  fs::resize_file(file, static_cast<uintmax_t>(static_cast<double>(fs::file_size(file)) * share));
}

std::string text_of(const Faults& faults) {
  std::string text;
  for (const Fault& fault : faults) text += fault.text() + "\n";
  return text;
}

}  // namespace svchain::testing
