#include "links/quiet_opencv.h"

#include <cstdlib>
#include <opencv2/core/utils/logger.hpp>

namespace svchain {

void quiet_opencv() {
  if (!std::getenv("OPENCV_LOG_LEVEL")) cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);  // AV_LOG_QUIET
}

}  // namespace svchain
