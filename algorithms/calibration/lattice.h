#pragma once
// Saddle points that lie like the corners of a checkerboard, joined to pieces of lattice: each has a
// neighbour one side away along the edges, where dark and light are exchanged. Pure.

#include "algorithms/calibration/saddle_points.h"

namespace svchain::calibration {

struct LatticeNode {
  Eigen::Vector2i place = {0, 0};  // in sides, along the lattice's own axes, which turn counter-clockwise
  Eigen::Vector2d ground_m;
  Eigen::Vector2d along_x_m, along_y_m;  // one side on the ground
  bool dark_diagonal = false;            // the quarters (+, +) and (-, -) are dark
};

using Lattice = std::vector<LatticeNode>;

/// Pieces of at least four nodes, not all in a row, largest first.
std::vector<Lattice> find_lattices(const std::vector<SaddlePoint>& saddles, double side_m);

}  // namespace svchain::calibration
