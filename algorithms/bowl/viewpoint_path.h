#pragma once
// The way from one viewpoint to another, and paths through key frames. The eye moves in cylindrical
// coordinates about the vehicle's vertical axis, by the shorter turn, so that the vehicle is gone around and
// not crossed; up turns with it, so that a look straight down and one from the side have none between them
// whose up is along the sight. A view from straight above counts as being behind its own upper edge. Plain
// values and functions; any thread may ask a path, which allocates nothing.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "algorithms/bowl/viewpoint.h"

namespace svchain::bowl {

/// Eye's radius, angle and height; target's x, y, z; up along the radius, the turn and the axis; field of
/// view.
using ViewpointCoordinates = Eigen::Matrix<double, 10, 1>;

/// The viewpoint a share t (0 to 1) of the way from a to b, smooth in t. It knows no bowl: where the wall is
/// steep and near, inside_bowl() of viewpoint_presets.h keeps it off.
Viewpoint mixed(const Viewpoint& a, const Viewpoint& b, double t);

struct KeyFrame {
  double time_s = 0;
  Viewpoint viewpoint;
};

/// Through all its key frames, with continuous speed: cubic Hermite in each coordinate, its slopes limited
/// after Fritsch and Butland (harmonic means), so that between two key frames no coordinate leaves the range
/// between theirs.
class ViewpointPath {
 public:
  /// Key frames by rising time; of a loop at least two, the last one being the first again. Throws
  /// std::invalid_argument where they are not.
  ViewpointPath(const std::vector<KeyFrame>& key_frames, bool loop);

  /// Before the first key frame that one, after the last that, or over again if it is a loop.
  Viewpoint at(double time_s) const;
  double begin_s() const { return times_.front(); }
  double end_s() const { return times_.back(); }
  bool loop() const { return loop_; }

 private:
  void choose_slopes();

  std::vector<double> times_;
  std::vector<ViewpointCoordinates> places_, slopes_;
  bool loop_;
};

/// Once around the vehicle in 12 s, counter-clockwise from behind, at the distance and height of "chase",
/// looking at the vehicle.
ViewpointPath orbit(const geometry::Vehicle& vehicle, const BowlSurface& surface);

}  // namespace svchain::bowl
