#include "algorithms/registration/brief.h"

#include <bit>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace svchain::registration {

namespace {

constexpr int kComparisons = 256;
constexpr int kFewest = 128;  // made in both descriptors
constexpr double kSmoothingPx = 2;

using Pattern = std::array<std::array<cv::Point, 2>, kComparisons>;

/// Evenly distributed in 0..1, the same everywhere (SplitMix64).
double next_unit(uint64_t& state) {
  uint64_t z = (state += 0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// Two normally distributed numbers (Box and Muller), inside the patch.
cv::Point next_place(uint64_t& state) {
  constexpr int kHalf = kPatchPx / 2;
  for (;;) {
    const double radius = kPatchPx / 5.0 * std::sqrt(-2 * std::log(1 - next_unit(state)));
    const double angle = 2 * std::numbers::pi * next_unit(state);
    const cv::Point place(static_cast<int>(std::lround(radius * std::cos(angle))),
                          static_cast<int>(std::lround(radius * std::sin(angle))));
    if (std::abs(place.x) <= kHalf && std::abs(place.y) <= kHalf) return place;
  }
}

Pattern drawn_pattern() {
  uint64_t state = 2010;
  Pattern pattern;
  for (auto& pair : pattern) {
    do pair = {next_place(state), next_place(state)};
    while (pair[0] == pair[1]);
  }
  return pattern;
}

}  // namespace

std::vector<Descriptor> describe(const cv::Mat& picture, const cv::Mat& seen,
                                 const std::vector<cv::Point>& places) {
  static const Pattern pattern = drawn_pattern();
  cv::Mat smooth;
  cv::GaussianBlur(picture, smooth, {0, 0}, kSmoothingPx);
  const cv::Rect inside({0, 0}, picture.size());
  const auto usable = [&](const cv::Point& at) { return inside.contains(at) && seen.at<uint8_t>(at); };
  std::vector<Descriptor> descriptors;
  for (const auto& place : places) {
    Descriptor descriptor{};
    for (int i = 0; i < kComparisons; ++i) {
      const cv::Point one = place + pattern[i][0], other = place + pattern[i][1];
      if (!usable(one) || !usable(other)) continue;
      descriptor.valid[i / 64] |= uint64_t{1} << (i % 64);
      if (smooth.at<float>(one) < smooth.at<float>(other)) descriptor.bits[i / 64] |= uint64_t{1} << (i % 64);
    }
    descriptors.push_back(descriptor);
  }
  return descriptors;
}

double distance(const Descriptor& one, const Descriptor& other) {
  int made = 0, different = 0;
  for (size_t i = 0; i < one.bits.size(); ++i) {
    const uint64_t both = one.valid[i] & other.valid[i];
    made += std::popcount(both);
    different += std::popcount((one.bits[i] ^ other.bits[i]) & both);
  }
  return made < kFewest ? 1 : static_cast<double>(different) / made;
}

}  // namespace svchain::registration
