#pragma once
// Which cameras show what a picture of the bowl shows at a pixel, and where in their images. That is found
// exactly at every eighth pixel each way; a square between is interpolated where its middle, found exactly
// too, says that it may be, and cut in four where it bends, has an end or changes hands. Keeps lenses alive.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/bowl/viewpoint.h"
#include "algorithms/synthesis/lut_cell.h"
#include "algorithms/synthesis/point_sources.h"

namespace svchain::bowl {

class SourceGrid {
 public:
  static constexpr int kSquarePx = 8;
  static constexpr double kTolerancePx = 0.1;    // of a camera's image
  static constexpr double kToleranceWeight = 4;  // 255ths

  /// Four cameras.
  SourceGrid(const geometry::Rig& rig, const BowlSurface& surface, const synthesis::BlendShape& shape);

  /// A new picture. Allocates where it has grown.
  void begin(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px);
  /// One of `parts` shares of the exact nodes, on any thread.
  void make_nodes(int part, int parts);
  /// Once all nodes are there, on any thread: the cells of a square of kSquarePx whose first pixel is a node,
  /// `pitch` cells from row to row.
  void fill(int column, int row, synthesis::Cell* cells, int pitch) const;

  const geometry::Rig& rig() const { return rig_; }

 private:
  using Node = synthesis::PointSources;
  using Corners = std::array<Node, 4>;  // upper left and right, lower left and right

  Node node_at(int column, int row) const;
  const Node& node(int column, int row) const {
    return nodes_[size_t(row / kSquarePx) * nodes_across_ + column / kSquarePx];
  }
  void fill(int column, int row, int size, const Corners& corners, synthesis::Cell* cells, int pitch) const;

  geometry::Rig rig_;
  BowlSurface surface_;
  synthesis::SourceFinder finder_;
  std::optional<Perspective> perspective_;
  int nodes_across_ = 0, nodes_down_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace svchain::bowl
