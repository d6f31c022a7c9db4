#include "algorithms/calibration/tag_finder.h"

#include <opencv2/aruco.hpp>

namespace svchain::calibration {

std::vector<FoundTag> find_tags(const cv::Mat& grey) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> clockwise;  // from the upper left corner
  cv::aruco::detectMarkers(grey, dictionary, clockwise, ids, parameters);
  std::vector<FoundTag> found(ids.size());
  for (size_t i = 0; i < ids.size(); ++i) {
    found[i].id = ids[i];
    for (size_t k = 0; k < 4; ++k) found[i].corners_px[k] = {clockwise[i][3 - k].x, clockwise[i][3 - k].y};
  }
  return found;
}

}  // namespace svchain::calibration
