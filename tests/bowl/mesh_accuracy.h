#pragma once
// How far a mesh table is from the truth between its vertices, measured through the lenses at random points
// inside its triangles. Pure, any thread.

#include <cstdint>

#include "algorithms/bowl/mesh_table.h"

namespace svchain::bowl {

struct MeshAccuracy {
  size_t vertices = 0, triangles = 0, bytes = 0;
  size_t points = 0;                 // measured
  double worst_px = 0, mean_px = 0;  // distance of an interpolated texture coordinate from the true one
  double worst_weight = 0, mean_weight = 0;  // difference in 255ths
  size_t weights_off = 0;                    // points where it is more than kWeightOff, all of them
};
inline constexpr double kWeightOff = 10;

/// `points_a_triangle` random points in each triangle; those nearer than `corner_m` to a corner of the
/// vehicle, where all directions meet, are left out. So are, for the worst weight, those nearer than that to
/// where the pictures of both cameras end: both have faded there, all weights meet, and no triangle is small
/// enough. Texture coordinates count where they have a weight.
MeshAccuracy measure_accuracy(const MeshTable& table, const geometry::Rig& rig, const BowlSurface& surface,
                              const synthesis::BlendShape& shape, int points_a_triangle, double corner_m,
                              uint64_t seed);

}  // namespace svchain::bowl
