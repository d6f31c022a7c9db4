#pragma once
// BRIEF (Calonder, Lepetit, Strecha, Fua, ECCV 2010): 256 comparisons of two places in the smoothed patch
// around a corner, upright, the places drawn from a Gaussian of a fifth of the patch's width. Gain and offset
// of a camera change no comparison. Comparisons that reach beyond what is seen are left out. Pure.

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace svchain::registration {

struct Descriptor {
  std::array<uint64_t, 4> bits;
  std::array<uint64_t, 4> valid;  // comparisons that were made
};

inline constexpr int kPatchPx = 49;

/// Descriptors of places in a grey picture (CV_32F) of which `seen` (CV_8U) is not 0.
std::vector<Descriptor> describe(const cv::Mat& picture, const cv::Mat& seen,
                                 const std::vector<cv::Point>& places);

/// Share of comparisons that differ, 0..1; 1 where too few were made in both to tell.
double distance(const Descriptor& one, const Descriptor& other);

}  // namespace svchain::registration
