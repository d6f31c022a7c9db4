#include "algorithms/calibration/tag_finder.h"

#include <map>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

namespace svchain::calibration {

std::vector<FoundTag> find_tags(const cv::Mat& grey) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  parameters->adaptiveThreshWinSizeMax = 43;
  // Else the outline of a tag's light margin, which is larger, takes the place of the tag.
  parameters->minMarkerDistanceRate = 0.005;
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> clockwise;  // from the upper left corner
  cv::aruco::detectMarkers(grey, dictionary, clockwise, ids, parameters);
  std::map<int, std::vector<cv::Point2f>> largest;  // of one tag's several outlines
  for (size_t i = 0; i < ids.size(); ++i) {
    auto& outline = largest[ids[i]];
    if (outline.empty() || cv::contourArea(clockwise[i]) > cv::contourArea(outline)) outline = clockwise[i];
  }
  std::vector<FoundTag> found;
  for (const auto& [tag, tag_outline] : largest) {
    const auto& outline = tag_outline;  // a lambda cannot capture the name of a part
    const auto corner = [&](size_t k) { return Eigen::Vector2d(outline[k].x, outline[k].y); };
    found.push_back({tag, {corner(3), corner(2), corner(1), corner(0)}});
  }
  return found;
}

}  // namespace svchain::calibration
