#pragma once
// Opening by name what OpenCV can open on Linux: files and streams, pipelines, devices, image sequences.

#include <opencv2/videoio.hpp>
#include <string>

namespace svchain {

/// False where none of them can. Backends are asked by name: left to itself, OpenCV would look for cameras on
/// every bus whenever a file cannot be opened.
inline bool open_video(cv::VideoCapture& capture, const std::string& name) {
  for (const int backend : {cv::CAP_FFMPEG, cv::CAP_GSTREAMER, cv::CAP_V4L2, cv::CAP_IMAGES}) {
    if (capture.open(name, backend)) return true;
  }
  return false;
}

}  // namespace svchain
