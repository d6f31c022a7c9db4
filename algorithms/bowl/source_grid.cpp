#include "algorithms/bowl/source_grid.h"

#include <algorithm>
#include <cmath>

#include "algorithms/synthesis/camera_shares.h"
#include "algorithms/synthesis/fixed_point.h"

namespace svchain::bowl {
namespace {

using synthesis::Cell;
using synthesis::PointSources;
using synthesis::RegionKind;
using Corners = std::array<PointSources, 4>;

/// The camera that a place shows alone, -1 for none.
int alone(const PointSources& sources) {
  if (sources.count == 1) return sources.camera[0];
  if (sources.count == 2 && sources.first_weight == 255) return sources.camera[0];
  if (sources.count == 2 && sources.first_weight == 0) return sources.camera[1];
  return -1;
}

const Eigen::Vector2d& place_of(const PointSources& sources, int camera) {
  return sources.image_px[sources.camera[0] == camera ? 0 : 1];
}

template <class Holds>
bool all_of(const Corners& corners, Holds holds) {
  return std::all_of(corners.begin(), corners.end(), holds);
}

/// What all corners of a square show alike: black, one camera or two; nothing where they differ.
struct Common {
  int count = 0;
  std::array<int, 2> camera = {-1, -1};
};
std::optional<Common> common_to(const Corners& corners) {
  const PointSources& first = corners[0];
  if (all_of(corners, [](const auto& c) { return c.count == 0; })) return Common{};
  const int only = alone(first);
  if (only >= 0 && all_of(corners, [&](const auto& c) { return alone(c) == only; }))
    return Common{1, {only, -1}};
  const auto same_two = [&](const auto& c) { return c.count == 2 && c.camera == first.camera; };
  if (all_of(corners, same_two)) return Common{2, first.camera};
  return std::nullopt;
}

/// Values at a square's corners, as they change from row to row and from column to column.
template <class T>
struct Bilinear {
  template <class ValueOf>
  Bilinear(const Corners& corners, int size, ValueOf of)
      : left(of(corners[0])),
        right(of(corners[1])),
        left_step((T(of(corners[2])) - left) / size),
        right_step((T(of(corners[3])) - right) / size) {}
  T at(double column, double row, int size) const {
    const T from = left + left_step * row, to = right + right_step * row;
    return from + (to - from) * (column / size);
  }
  T left, right, left_step, right_step;
};
using Place = Bilinear<Eigen::Vector2d>;

Place places(const Corners& corners, int camera, int size) {
  return Place(corners, size, [&](const auto& c) { return place_of(c, camera); });
}
Bilinear<double> weights(const Corners& corners, int size) {
  return Bilinear<double>(corners, size, [](const auto& c) { return double(c.first_weight); });
}

/// Whether interpolation gives what has been found at a place of a square.
bool fits(const Common& common, const Corners& corners, int size, int column, int row,
          const PointSources& there) {
  if (common.count == 0) return there.count == 0;
  const auto close = [&](int camera) {
    const Eigen::Vector2d between = places(corners, camera, size).at(column, row, size);
    return (between - place_of(there, camera)).lpNorm<Eigen::Infinity>() <= SourceGrid::kTolerancePx;
  };
  if (common.count == 1) return alone(there) == common.camera[0] && close(common.camera[0]);
  return there.count == 2 && there.camera == common.camera && close(common.camera[0]) &&
         close(common.camera[1]) &&
         std::abs(weights(corners, size).at(column, row, size) - there.first_weight) <=
             SourceGrid::kToleranceWeight;
}

/// Over so steep a blend, one place says too little.
bool is_steep(const Common& common, const Corners& corners) {
  constexpr int kSteepWeights = 48;
  if (common.count < 2) return false;
  const auto [least, most] =
      std::minmax_element(corners.begin(), corners.end(),
                          [](const auto& a, const auto& b) { return a.first_weight < b.first_weight; });
  return most->first_weight - least->first_weight > kSteepWeights;
}

/// One camera's places along the rows of a square, in 1/32 px, rounded.
void fill_taps(const geometry::Rig& rig, int camera, const Corners& corners, int size, int tap, Cell* cells,
               int pitch) {
  const Place place = places(corners, camera, size);
  const Eigen::Array2f largest =
      ((rig.cameras[camera].image_size_px.array() - 1) * int{synthesis::kOnePixel} - 1).cast<float>();
  for (int row = 0; row < size; ++row, cells += pitch) {
    const Eigen::Array2f from =
        ((place.left + place.left_step * row) * synthesis::kOnePixel).cast<float>().array() + 0.5f;
    const Eigen::Array2f to =
        ((place.right + place.right_step * row) * synthesis::kOnePixel).cast<float>().array() + 0.5f;
    const Eigen::Array2f step = (to - from) / static_cast<float>(size);
    for (int column = 0; column < size; ++column) {
      const Eigen::Array2f at = (from + step * static_cast<float>(column)).max(0.0f).min(largest);
      cells[column].taps[tap] = {camera, static_cast<int>(at.x()), static_cast<int>(at.y())};
    }
  }
}

void fill_kinds(RegionKind kind, int size, Cell* cells, int pitch) {
  for (int row = 0; row < size; ++row, cells += pitch)
    for (int column = 0; column < size; ++column) cells[column].kind = kind;
}

/// A blend that has come to its end is one camera.
void fill_weights(const Corners& corners, int size, Cell* cells, int pitch) {
  const Bilinear<double> weight = weights(corners, size);
  for (int row = 0; row < size; ++row, cells += pitch)
    for (int column = 0; column < size; ++column) {
      Cell& cell = cells[column];
      const int rounded = static_cast<int>(weight.at(column, row, size) + 0.5);
      cell.kind = rounded > 0 && rounded < 255 ? RegionKind::kBlend : RegionKind::kCamera;
      cell.weight = cell.kind == RegionKind::kBlend ? static_cast<uint8_t>(rounded) : uint8_t{0};
      if (rounded <= 0) cell.taps[0] = cell.taps[1];
    }
}

void interpolate(const geometry::Rig& rig, const Common& common, const Corners& corners, int size,
                 Cell* cells, int pitch) {
  for (int tap = 0; tap < common.count; ++tap)
    fill_taps(rig, common.camera[tap], corners, size, tap, cells, pitch);
  if (common.count == 2) return fill_weights(corners, size, cells, pitch);
  fill_kinds(common.count == 1 ? RegionKind::kCamera : RegionKind::kBlack, size, cells, pitch);
}

/// find_pair's two cameras, of which one may have no share.
Cell exact_cell(PointSources sources, const geometry::Rig& rig) {
  if (const int only = alone(sources); only >= 0 && sources.count == 2) {
    sources.image_px[0] = place_of(sources, only);
    sources.camera[0] = only;
    sources.count = 1;
  }
  return make_cell(sources, rig);
}

}  // namespace

SourceGrid::SourceGrid(const geometry::Rig& rig, const BowlSurface& surface,
                       const synthesis::BlendShape& shape)
    : rig_(rig), surface_(surface), finder_(rig, shape) {}

void SourceGrid::begin(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px) {
  perspective_.emplace(viewpoint, size_px);
  nodes_across_ = (size_px.x() + kSquarePx - 1) / kSquarePx + 1;
  nodes_down_ = (size_px.y() + kSquarePx - 1) / kSquarePx + 1;
  nodes_.resize(size_t(nodes_across_) * nodes_down_);
}

void SourceGrid::make_nodes(int part, int parts) {
  const size_t begin = nodes_.size() * part / parts, end = nodes_.size() * (part + 1) / parts;
  for (size_t i = begin; i < end; ++i)
    nodes_[i] = node_at(static_cast<int>(i) % nodes_across_ * kSquarePx,
                        static_cast<int>(i) / nodes_across_ * kSquarePx);
}

SourceGrid::Node SourceGrid::node_at(int column, int row) const {
  const auto point = surface_.intersect(perspective_->eye(), perspective_->ray({column, row}));
  if (!point || synthesis::is_under_vehicle(rig_.vehicle, point->head<2>())) return {};
  return finder_.find_pair(*point);
}

void SourceGrid::fill(int column, int row, Cell* cells, int pitch) const {
  const int right = column + kSquarePx, below = row + kSquarePx;
  fill(column, row, kSquarePx, {node(column, row), node(right, row), node(column, below), node(right, below)},
       cells, pitch);
}

void SourceGrid::fill(int column, int row, int size, const Corners& corners, Cell* cells, int pitch) const {
  if (size == 1) {
    *cells = exact_cell(corners[0], rig_);
    return;
  }
  const int half = size / 2;
  const Node middle = node_at(column + half, row + half);
  const std::optional<Common> common = common_to(corners);
  if (common && !is_steep(*common, corners) && fits(*common, corners, size, half, half, middle) &&
      (size < kSquarePx || fits(*common, corners, size, 2, 6, node_at(column + 2, row + 6))))
    return interpolate(rig_, *common, corners, size, cells, pitch);
  const Node above = node_at(column + half, row), below = node_at(column + half, row + size);
  const Node left = node_at(column, row + half), right = node_at(column + size, row + half);
  fill(column, row, half, {corners[0], above, left, middle}, cells, pitch);
  fill(column + half, row, half, {above, corners[1], middle, right}, cells + half, pitch);
  fill(column, row + half, half, {left, middle, corners[2], below}, cells + half * pitch, pitch);
  fill(column + half, row + half, half, {middle, right, below, corners[3]}, cells + half * pitch + half,
       pitch);
}

}  // namespace svchain::bowl
