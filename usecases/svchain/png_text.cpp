#include "usecases/svchain/png_text.h"

#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace svchain::program {

std::string png_text(const cv::Mat& picture) {
  std::vector<uchar> png;
  cv::imencode(".png", picture, png);
  return {png.begin(), png.end()};
}

}  // namespace svchain::program
