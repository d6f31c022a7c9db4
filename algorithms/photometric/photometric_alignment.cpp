#include "algorithms/photometric/photometric_alignment.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "algorithms/photometric/starting_shift.h"

namespace svchain::photometric {
namespace {

using synthesis::kChannels;

constexpr int kFirstSteps = 8;
/// A camera whose brightness has changed by this much (ln) is caught up with half as fast as one that has
/// changed by far more: what is below is noise, and left to the smooth fit.
constexpr double kChange = 0.03;
constexpr double kCatchUp = 0.6;  // of a large change, with every frame
constexpr double kReturn = 0.1;   // to the common level, relative to the smoothing
const double kLargestLogGain = std::log(4.0);

AlignmentSettings checked(const AlignmentSettings& settings) {
  const auto refuse = [](const std::string& what) {
    throw std::invalid_argument("photometric alignment: " + what);
  };
  if (settings.cameras < 1 || settings.cameras > synthesis::kMaxCameras)
    refuse(std::to_string(settings.cameras) + " cameras, expected 1 to 8");
  if (!(settings.smoothing > 0 && settings.smoothing <= 1))
    refuse("smoothing " + std::to_string(settings.smoothing) + ", expected above 0 and at most 1");
  return settings;
}

double difference(const SharedBlock& block, const ToneCurves& curves, size_t channel) {
  return std::abs(std::exp(block.log_level(curves, 0, channel)) -
                  std::exp(block.log_level(curves, 1, channel)));
}

/// Every knot of every camera and channel.
template <class F>
void for_each_knot(ToneCurves& curves, size_t cameras, F f) {
  for (size_t i = 0; i < cameras; ++i)
    for (auto& knots : curves.log_gain[i])
      for (double& s : knots) f(s);
}

}  // namespace

PhotometricAlignment::PhotometricAlignment(const AlignmentSettings& settings)
    : settings_(checked(settings)),
      evidence_(settings.most_blocks),
      fit_(settings.cameras, settings.most_blocks, settings.falloff),
      tone_mapping_(synthesis::ToneMapping::identity()) {
  scratch_.reserve(settings.most_blocks);
}

const synthesis::ToneMapping& PhotometricAlignment::update(const synthesis::OverlapStatistics& statistics) {
  ++frames_;
  evidence_.take(statistics, settings_.cameras);
  contradicting_ = 0;
  if (evidence_.blocks().empty()) {
    ++frames_held_;
    return tone_mapping_;
  }
  if (started_) {
    follow();
  } else {
    start();
  }
  contradicting_ = fit_.contradicting();
  for_each_knot(curves_, settings_.cameras,
                [](double& s) { s = std::clamp(s, -kLargestLogGain, kLargestLogGain); });
  tone_mapping_ = photometric::tone_mapping(curves_, settings_.cameras);
  return tone_mapping_;
}

/// All at once, the curves' geometric mean being the identity.
void PhotometricAlignment::start() {
  const Shifts shifts = starting_shifts(evidence_, curves_, settings_.cameras, scratch_);
  for (size_t c = 0; c < kChannels; ++c) {
    double sum = 0, shown = 0;
    for (size_t i = 0; i < settings_.cameras; ++i) {
      if (!evidence_.shows(i)) continue;
      sum += shifts[i][c];
      ++shown;
    }
    for (size_t i = 0; i < settings_.cameras; ++i)
      if (evidence_.shows(i)) curves_.log_gain[i][c].fill(shifts[i][c] - sum / shown);
  }
  for (int i = 0; i < kFirstSteps; ++i) fit_.step(evidence_, 1, curves_);
  started_ = true;
}

void PhotometricAlignment::follow() {
  shift_changed_cameras();
  fit_.step(evidence_, settings_.smoothing, curves_);
  return_to_common_level();
}

void PhotometricAlignment::shift_changed_cameras() {
  const Shifts shifts = starting_shifts(evidence_, curves_, settings_.cameras, scratch_);
  for (size_t i = 0; i < settings_.cameras; ++i) {
    double change = 0;
    for (const double shift : shifts[i]) change = std::max(change, std::abs(shift));
    const double large = std::pow(change / kChange, 4);
    const double share = kCatchUp * large / (1 + large);
    for (size_t c = 0; c < kChannels; ++c)
      for (double& s : curves_.log_gain[i][c]) s += share * shifts[i][c];
  }
}

void PhotometricAlignment::return_to_common_level() {
  for (size_t c = 0; c < kChannels; ++c)
    for (int k = 0; k < kKnots; ++k) {
      double mean = 0;
      for (size_t i = 0; i < settings_.cameras; ++i)
        mean += curves_.log_gain[i][c][k] / double(settings_.cameras);
      for (size_t i = 0; i < settings_.cameras; ++i)
        curves_.log_gain[i][c][k] -= kReturn * settings_.smoothing * mean;
    }
}

Rejections PhotometricAlignment::rejections() const {
  Rejections rejections = evidence_.rejections();
  rejections.contradicting += contradicting_;
  return rejections;
}

std::vector<OverlapDifference> PhotometricAlignment::differences() const {
  std::vector<OverlapDifference> overlaps;
  const ToneCurves identity;
  for (const SharedBlock& block : evidence_.blocks()) {
    const auto same = [&](const OverlapDifference& overlap) {
      return overlap.camera_a == block.cameras[0] && overlap.camera_b == block.cameras[1];
    };
    auto overlap = std::find_if(overlaps.begin(), overlaps.end(), same);
    if (overlap == overlaps.end())
      overlap = overlaps.insert(overlap, {block.cameras[0], block.cameras[1], 0, 0, 0});
    ++overlap->blocks;
    for (size_t c = 0; c < kChannels; ++c) {
      overlap->before += difference(block, identity, c) / kChannels;
      overlap->after += difference(block, curves_, c) / kChannels;
    }
  }
  for (OverlapDifference& overlap : overlaps) {
    overlap.before /= double(overlap.blocks);
    overlap.after /= double(overlap.blocks);
  }
  return overlaps;
}

}  // namespace svchain::photometric
