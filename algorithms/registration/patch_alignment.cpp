#include "algorithms/registration/patch_alignment.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace svchain::registration {

namespace {

constexpr int kHalf = 9;  // of the patch, px
constexpr int kSide = 2 * kHalf + 1;
constexpr double kFlat = 3;     // grey levels of standard deviation, below which a patch shows nothing
constexpr double kEdge = 0.12;  // of the normal matrix's eigenvalues; below, a patch may slide along an edge
constexpr double kAlike = 0.8;  // correlation
constexpr double kPixelBlur = 0.6;  // standard deviation of a camera's own blur, in its pixels

using Patch = Eigen::Array<double, kSide, kSide>;  // row by row as in the picture

float sample(const cv::Mat& picture, float x, float y) {
  const int i = static_cast<int>(x), j = static_cast<int>(y);  // both positive
  const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
  const auto* upper = picture.ptr<float>(j) + i;
  const auto* lower = picture.ptr<float>(j + 1) + i;
  return (1 - t) * ((1 - s) * upper[0] + s * upper[1]) + t * ((1 - s) * lower[0] + s * lower[1]);
}

cv::Rect square(const cv::Point& middle, int half) {
  return {middle.x - half, middle.y - half, 2 * half + 1, 2 * half + 1};
}

/// The square of `half` pixels about `middle` as it would look through another camera's pixels. Empty where
/// the patch is not all seen.
cv::Mat smeared(const cv::Mat& picture, const cv::Mat& seen, const cv::Point& middle, int half,
                const Eigen::Matrix2d& picture_from_image) {
  constexpr int kNodes = 2;       // each way
  constexpr double kApart = 1.0;  // in standard deviations
  const Eigen::Matrix2d node = kPixelBlur * kApart * picture_from_image;
  const double farthest = kNodes * node.cwiseAbs().rowwise().sum().maxCoeff();
  if (!(farthest < picture.cols)) return {};  // also where a camera's pixel covers endlessly much
  const int reach = half + 2 + static_cast<int>(farthest);
  const cv::Rect read = square(middle, reach), shown = square(middle, kHalf);
  if ((read & cv::Rect({0, 0}, seen.size())) != read) return {};
  if (cv::countNonZero(seen(shown)) != shown.area()) return {};
  cv::Mat patch = cv::Mat::zeros(2 * half + 1, 2 * half + 1, CV_32F);
  double sum = 0;
  for (int k = 0; k < (2 * kNodes + 1) * (2 * kNodes + 1); ++k) {
    const Eigen::Vector2d at(k % (2 * kNodes + 1) - kNodes, k / (2 * kNodes + 1) - kNodes);
    const double weight = std::exp(-0.5 * kApart * kApart * at.squaredNorm());
    const Eigen::Vector2f from =
        (node * at + Eigen::Vector2d(middle.x - half, middle.y - half)).cast<float>();
    sum += weight;
    for (int j = 0; j < patch.rows; ++j) {
      auto* row = patch.ptr<float>(j);
      for (int i = 0; i < patch.cols; ++i) {
        row[i] += static_cast<float>(weight) *
                  sample(picture, from.x() + static_cast<float>(i), from.y() + static_cast<float>(j));
      }
    }
  }
  patch /= sum;
  return patch;
}

/// The patch about a place, without its mean.
Patch centred_patch(const cv::Mat& picture, const Eigen::Vector2d& middle) {
  const Eigen::Vector2f corner = (middle.array() - kHalf).matrix().cast<float>();
  Patch patch;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      patch(j, i) = sample(picture, corner.x() + static_cast<float>(i), corner.y() + static_cast<float>(j));
    }
  }
  return patch - patch.mean();
}

/// What is sought, with its derivatives.
struct Template {
  Patch patch, along_x, along_y;
  double norm = 0;
  Eigen::Matrix2d normal;

  explicit Template(const cv::Mat& picture) {
    const Eigen::Vector2d middle(picture.cols / 2, picture.rows / 2);
    const Eigen::Vector2d x = Eigen::Vector2d::UnitX(), y = Eigen::Vector2d::UnitY();
    patch = centred_patch(picture, middle);
    norm = std::sqrt(patch.square().sum());
    along_x = (centred_patch(picture, middle + x) - centred_patch(picture, middle - x)) / 2;
    along_y = (centred_patch(picture, middle + y) - centred_patch(picture, middle - y)) / 2;
    const double across = (along_x * along_y).sum();
    normal << along_x.square().sum(), across, across, along_y.square().sum();
  }

  bool is_corner() const {
    const double half = normal.trace() / 2;
    const double apart = std::sqrt(std::max(0.0, half * half - normal.determinant()));
    return norm >= kFlat * kSide && half - apart >= kEdge * (half + apart);
  }
};

}  // namespace

std::optional<Eigen::Vector2d> aligned_patch(const SmearedPicture& a, const SmearedPicture& b,
                                             const cv::Mat& seen, const cv::Point& at,
                                             const cv::Point& start) {
  constexpr int kMostRounds = 20;
  constexpr double kSettled = 0.01;  // px
  const cv::Mat from = smeared(a.picture, seen, at, kHalf + 2, b.picture_from_image);
  const cv::Mat to = smeared(b.picture, seen, at + start, kHalf + 2 + kNudgePx, a.picture_from_image);
  if (from.empty() || to.empty()) return std::nullopt;
  const Template wanted(from);
  if (!wanted.is_corner()) return std::nullopt;
  const Eigen::Vector2d middle(to.cols / 2, to.rows / 2);
  Eigen::Vector2d nudge = Eigen::Vector2d::Zero();
  for (int round = 0; round < kMostRounds && nudge.norm() <= kNudgePx; ++round) {
    const Patch found = centred_patch(to, middle + nudge);
    const double found_norm = std::sqrt(found.square().sum());
    if (found_norm < kFlat * kSide) return std::nullopt;
    const Patch error = found * (wanted.norm / found_norm) - wanted.patch;
    const Eigen::Vector2d step = wanted.normal.ldlt().solve(
        Eigen::Vector2d((wanted.along_x * error).sum(), (wanted.along_y * error).sum()));
    if (!step.allFinite()) return std::nullopt;
    nudge -= step;
    if (step.norm() > kSettled) continue;
    const double correlation = (found * wanted.patch).sum() / (found_norm * wanted.norm);
    if (correlation < kAlike) return std::nullopt;
    return Eigen::Vector2d(start.x, start.y) + nudge;
  }
  return std::nullopt;
}

}  // namespace svchain::registration
