#include "algorithms/photometric/photometric_alignment.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace svchain::photometric {

PhotometricAlignment::PhotometricAlignment(size_t cameras, double smoothing)
    : cameras_(cameras),
      smoothing_(smoothing),
      gains_(Gains::identity()),
      tone_mapping_(synthesis::ToneMapping::identity()) {
  if (cameras < 1 || cameras > synthesis::kMaxCameras)
    throw std::invalid_argument("photometric alignment: " + std::to_string(cameras) +
                                " cameras, expected 1 to 8");
  if (!(smoothing > 0 && smoothing <= 1))
    throw std::invalid_argument("photometric alignment: smoothing " + std::to_string(smoothing) +
                                ", expected above 0 and at most 1");
}

const synthesis::ToneMapping& PhotometricAlignment::update(const synthesis::OverlapStatistics& statistics) {
  const Gains estimate = estimate_gains(statistics, cameras_, gains_);
  const double step = started_ ? smoothing_ : 1;
  for (size_t i = 0; i < cameras_; ++i)
    for (int c = 0; c < synthesis::kChannels; ++c)
      gains_.value[i][c] *= std::pow(estimate.value[i][c] / gains_.value[i][c], step);
  gains_.blocks_used = estimate.blocks_used;
  gains_.blocks_rejected = estimate.blocks_rejected;
  started_ = started_ || estimate.blocks_used > 0;
  tone_mapping_ = photometric::tone_mapping(gains_);
  return tone_mapping_;
}

}  // namespace svchain::photometric
