#include "tests/bowl/mesh_accuracy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "algorithms/bowl/pair_sights.h"

namespace svchain::bowl {
namespace {

Eigen::Vector3d random_parts(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  double a = unit(random), b = unit(random);
  if (a + b > 1) a = 1 - a, b = 1 - b;
  return {a, b, 1 - a - b};
}

double from_corner(const geometry::Vehicle& vehicle, const Eigen::Vector2d& ground) {
  return (ground.cwiseAbs() - Eigen::Vector2d(vehicle.length_m, vehicle.width_m) / 2).norm();
}

class Measurement {
 public:
  Measurement(const MeshTable& table, const PairSights& sights, double corner_m)
      : table_(table), sights_(sights), corner_m_(corner_m) {
    accuracy_.vertices = table.header().vertex_count;
    accuracy_.triangles = table.triangle_count();
    accuracy_.bytes = table.header().bytes;
  }

  /// `pair` is the one whose quarter the triangle is in.
  void take(const MeshBatch& batch, int pair, const std::array<MeshVertex, 3>& corner,
            const Eigen::Vector3d& parts, const Eigen::Vector2d& ground) {
    const PairSight truth = sights_.at(pair, ground);
    if (!truth.shown()) return;  // across the border of the last picture
    ++accuracy_.points;
    const bool alone = batch.first == batch.second;
    double weight = 0;
    for (int i = 0; i < 3; ++i) weight += parts[i] * corner[i].first_weight;
    const double shown = alone && int(batch.first) != pair ? 0 : weight;
    add_weight(std::abs(shown - truth.first_weight), pair, ground);
    for (int which = 0; which < (alone ? 1 : 2); ++which) {
      if ((which == 0 ? weight : 255 - weight) <= 0) continue;
      const auto& pixel = truth.pixel[alone && int(batch.first) != pair ? 1 : which];
      if (!pixel) continue;  // a sliver across the border of a picture
      Eigen::Vector2d interpolated(0, 0);
      for (int i = 0; i < 3; ++i) interpolated += parts[i] * table_.pixel(corner[i], which);
      add_px((interpolated - *pixel).norm());
    }
  }
  MeshAccuracy result() const {
    MeshAccuracy all = accuracy_;
    if (pixels_ > 0) all.mean_px = sum_px_ / static_cast<double>(pixels_);
    if (all.points > 0) all.mean_weight = sum_weight_ / static_cast<double>(all.points);
    return all;
  }

 private:
  void add_px(double error) {
    accuracy_.worst_px = std::max(accuracy_.worst_px, error);
    sum_px_ += error;
    ++pixels_;
  }
  void add_weight(double error, int pair, const Eigen::Vector2d& ground) {
    sum_weight_ += error;
    accuracy_.weights_off += error > kWeightOff;
    if (error > accuracy_.worst_weight && !both_pictures_end_near(pair, ground))
      accuracy_.worst_weight = error;
  }
  bool both_pictures_end_near(int pair, const Eigen::Vector2d& ground) const {
    constexpr int kDirections = 32;
    std::array<bool, 2> ends = {false, false};
    for (int i = 0; i < kDirections; ++i) {
      const Eigen::Vector2d way = Eigen::Rotation2Dd(2 * M_PI * i / kDirections) * Eigen::Vector2d::UnitX();
      for (const double part : {0.5, 1.0}) {
        const PairSight there = sights_.at(pair, ground + part * corner_m_ * way);
        for (size_t which = 0; which < 2; ++which) ends[which] = ends[which] || !there.pixel[which];
      }
    }
    return ends[0] && ends[1];
  }

  const MeshTable& table_;
  const PairSights& sights_;
  double corner_m_;
  MeshAccuracy accuracy_;
  double sum_px_ = 0, sum_weight_ = 0;
  size_t pixels_ = 0;
};

}  // namespace

MeshAccuracy measure_accuracy(const MeshTable& table, const geometry::Rig& rig, const BowlSurface& surface,
                              const synthesis::BlendShape& shape, int points_a_triangle, double corner_m,
                              uint64_t seed) {
  const PairSights sights(rig, surface, shape);
  Measurement measurement(table, sights, corner_m);
  std::mt19937_64 random(seed);
  for (const MeshBatch& batch : table.batches()) {
    const auto indices = table.indices(batch);
    for (size_t t = 0; t < indices.size(); t += 3) {
      std::array<MeshVertex, 3> corner;
      Eigen::Vector2d middle(0, 0);
      for (size_t i = 0; i < 3; ++i) {
        corner[i] = table.vertices()[indices[t + i]];
        middle += table.position(corner[i]).head<2>() / 3;
      }
      for (int n = 0; n < points_a_triangle; ++n) {
        const Eigen::Vector3d parts = random_parts(random);
        Eigen::Vector2d ground(0, 0);
        for (int i = 0; i < 3; ++i) ground += parts[i] * table.position(corner[i]).head<2>();
        if (from_corner(rig.vehicle, ground) > corner_m)
          measurement.take(batch, pair_at(middle), corner, parts, ground);
      }
    }
  }
  return measurement.result();
}

}  // namespace svchain::bowl
