#include "algorithms/calibration/fragments.h"

#include <algorithm>
#include <set>

#include "algorithms/calibration/corner_fit.h"
#include "algorithms/calibration/lattice.h"
#include "algorithms/calibration/single_squares.h"
#include "algorithms/calibration/tag_finder.h"

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr size_t kLeastCorners = 4;
// Beside a large piece of lattice small ones, which are often false, can wait for the second look.
constexpr size_t kSureCorners = 6;
constexpr size_t kLargeCorners = 8;

std::optional<Vector2d> pixel_of(const geometry::Camera& camera, const Vector2d& ground_m) {
  return camera.see(Vector3d(ground_m.x(), ground_m.y(), 0));
}

/// The corner near a place on the ground, its edges reaching so far there.
std::optional<FittedCorner> fit_at(const geometry::Camera& camera, const cv::Mat& grey,
                                   const Vector2d& ground_m, const Vector2d& along_x_m,
                                   const Vector2d& along_y_m, DarkQuarters dark) {
  constexpr double kShare = 0.1;  // of the reach, over which the picture is taken to be even
  const auto pixel = pixel_of(camera, ground_m);
  const auto along_x = pixel_of(camera, ground_m + kShare * along_x_m);
  const auto along_y = pixel_of(camera, ground_m + kShare * along_y_m);
  if (!pixel || !along_x || !along_y) return std::nullopt;
  return fit_corner(grey, *camera.lens,
                    {*pixel, (*along_x - *pixel) / kShare, (*along_y - *pixel) / kShare, dark});
}

Fragment pattern_of(const Lattice& lattice, double side_m) {
  Fragment fragment;
  for (const auto& node : lattice) {
    FragmentCorner corner;
    corner.place_m = side_m * node.place.cast<double>();
    corner.dark = node.dark_diagonal ? 0b0101 : 0b1010;
    fragment.corners.push_back(corner);
  }
  return fragment;
}

Fragment fragment_of(const Lattice& lattice, double side_m, const geometry::Camera& camera,
                     const cv::Mat& grey) {
  const Fragment pattern = pattern_of(lattice, side_m);
  Fragment fragment;
  for (size_t i = 0; i < lattice.size(); ++i) {
    FragmentCorner corner = pattern.corners[i];
    const auto fitted =
        fit_at(camera, grey, lattice[i].ground_m, lattice[i].along_x_m, lattice[i].along_y_m, corner.dark);
    if (!fitted) continue;
    corner.pixel = fitted->pixel;
    corner.covariance_px2 = fitted->covariance_px2;
    fragment.corners.push_back(corner);
  }
  return fragment;
}

bool is_lattice(const Fragment& fragment) {
  return !fragment.corners.empty() && ChartCorner{{}, fragment.corners.front().dark, 0}.is_saddle();
}

/// A corner of a single square, on its own plane.
FragmentCorner single_corner(size_t number, double side_m) {
  const ChartCorner known = square_corner({0, 0}, side_m, number);
  FragmentCorner corner;
  corner.place_m = known.place_m;
  corner.dark = known.dark;
  return corner;
}

Fragment fragment_of(const GroundSquare& square, double side_m, double reach_m,
                     const geometry::Camera& camera, const cv::Mat& grey) {
  const Vector2d x = (square[1] - square[0] + square[2] - square[3]) / 2 * (reach_m / side_m);
  const Vector2d y = (square[3] - square[0] + square[2] - square[1]) / 2 * (reach_m / side_m);
  Fragment fragment;
  for (size_t k = 0; k < 4; ++k) {
    FragmentCorner corner = single_corner(k, side_m);
    const auto fitted = fit_at(camera, grey, square[k], x, y, corner.dark);
    if (!fitted) continue;
    corner.pixel = fitted->pixel;
    corner.covariance_px2 = fitted->covariance_px2;
    fragment.corners.push_back(corner);
  }
  return fragment;
}

cv::Mat grey8(const GroundPicture& picture) {
  cv::Mat made;
  picture.grey.convertTo(made, CV_8U);
  return made;
}

GroundPicture tag_picture(double side_m, const geometry::Camera& camera, const cv::Mat& grey) {
  constexpr double kPart = 6;           // of a tag, that is kSidePx wide in the picture laid on the ground
  constexpr double kLeastPartPx = 1.6;  // in the camera's: so that cells are told apart
  return ground_picture(camera, grey, side_m / kPart, kLeastPartPx);
}

/// Tags, whose edges are a cell wide only: where a corner of one is too small to be fitted, it is as it was
/// found.
std::vector<Fragment> find_tag_fragments(double side_m, const geometry::Camera& camera, const cv::Mat& grey) {
  constexpr double kRoughSigmaPx = 0.4;
  constexpr double kCellsAcross = 8;
  const GroundPicture picture = tag_picture(side_m, camera, grey);
  std::vector<Fragment> found;
  for (const auto& tag : find_tags(grey8(picture))) {
    GroundSquare square;
    for (size_t k = 0; k < 4; ++k) square[k] = picture.view.ground_from_pixel(tag.corners_px[k]);
    Fragment fitted = fragment_of(square, side_m, side_m / kCellsAcross, camera, grey);
    Fragment fragment;
    fragment.tag_id = tag.id;
    for (size_t k = 0; k < 4; ++k) {
      FragmentCorner corner = single_corner(k, side_m);
      const auto same = std::find_if(fitted.corners.begin(), fitted.corners.end(),
                                     [&](const auto& other) { return other.dark == corner.dark; });
      if (same != fitted.corners.end()) {
        corner = *same;
      } else if (const auto pixel = pixel_of(camera, square[k])) {
        corner.pixel = *pixel;
        corner.covariance_px2 *= kRoughSigmaPx * kRoughSigmaPx;
      }
      fragment.corners.push_back(corner);
    }
    found.push_back(std::move(fragment));
  }
  return found;
}

/// Sides of lattices, and of single squares with the reach of their corners, that these charts show.
struct Patterns {
  std::set<double> lattice_sides_m;
  std::set<std::pair<double, double>> square_sides_m;
  std::set<double> tag_sides_m;
};

Patterns patterns_of(const std::vector<Chart>& charts) {
  Patterns patterns;
  for (const auto& chart : charts) {
    if (chart.type == ChartType::kAprilTag36h11) {
      patterns.tag_sides_m.insert(chart.side_m);
      continue;
    }
    const auto all = corners(chart);
    const bool has_saddles = std::any_of(all.begin(), all.end(), [](const auto& c) { return c.is_saddle(); });
    if (has_saddles) {
      patterns.lattice_sides_m.insert(chart.side_m);
      continue;
    }
    double reach_m = chart.side_m;
    for (const auto& corner : all) reach_m = std::min(reach_m, corner.reach_m);
    patterns.square_sides_m.insert({chart.side_m, reach_m});
  }
  return patterns;
}

}  // namespace

std::vector<Fragment> find_fragments(const geometry::Camera& camera, const cv::Mat& grey,
                                     const std::vector<Chart>& charts) {
  const Patterns patterns = patterns_of(charts);
  std::vector<Fragment> found;
  for (const double side_m : patterns.lattice_sides_m) {
    const auto saddles = find_saddles(ground_picture(camera, grey, side_m));
    for (const auto& lattice : find_lattices(saddles, side_m))
      found.push_back(fragment_of(lattice, side_m, camera, grey));
  }
  for (const auto& [side_m, reach_m] : patterns.square_sides_m) {
    const GroundPicture picture = ground_picture(camera, grey, side_m);
    for (const auto& square : find_single_squares(picture))
      found.push_back(fragment_of(square, side_m, reach_m, camera, grey));
  }
  for (const double side_m : patterns.tag_sides_m) {
    for (auto& fragment : find_tag_fragments(side_m, camera, grey)) found.push_back(std::move(fragment));
  }
  const bool some_are_large = std::any_of(found.begin(), found.end(), [](const Fragment& f) {
    return !f.tag_id && f.corners.size() >= kLargeCorners;
  });
  std::erase_if(found, [&](const Fragment& f) {
    const size_t least = some_are_large && is_lattice(f) ? kSureCorners : kLeastCorners;
    return f.corners.size() < least;
  });
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.corners.size() > b.corners.size(); });
  return found;
}

std::vector<Fragment> find_patterns(const geometry::Camera& camera, const cv::Mat& grey,
                                    const std::vector<Chart>& charts) {
  const Patterns patterns = patterns_of(charts);
  std::vector<Fragment> found;
  const auto add_square = [&](double side_m, std::optional<int> tag_id) {
    Fragment fragment;
    for (size_t k = 0; k < 4; ++k) fragment.corners.push_back(single_corner(k, side_m));
    fragment.tag_id = tag_id;
    found.push_back(std::move(fragment));
  };
  for (const double side_m : patterns.lattice_sides_m) {
    for (const auto& lattice : find_lattices(find_saddles(ground_picture(camera, grey, side_m)), side_m))
      found.push_back(pattern_of(lattice, side_m));
  }
  for (const auto& [side_m, reach_m] : patterns.square_sides_m) {
    for (size_t n = find_single_squares(ground_picture(camera, grey, side_m)).size(); n > 0; --n)
      add_square(side_m, std::nullopt);
  }
  for (const double side_m : patterns.tag_sides_m) {
    for (const auto& tag : find_tags(grey8(tag_picture(side_m, camera, grey)))) add_square(side_m, tag.id);
  }
  return found;
}

}  // namespace svchain::calibration
