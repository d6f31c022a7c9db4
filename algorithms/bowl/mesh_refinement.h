#pragma once
// Where the triangles over a bowl have to be small, and which cameras each of them shows. A triangle shows a
// pair of cameras where both see all its corners, else the one that does; one that no camera sees whole is
// left out. One is cut while, at the middles of its edges or its own, a texture coordinate interpolated from
// its corners is further off than the tolerance, or a weight than a few 255ths; and while it lies across the
// border of a picture, so that what is left out or shown by one camera ends near that border. That goes down
// to a smallest size only, and there are places where no triangle is small enough: about the vehicle's
// corners all directions meet, and where the pictures of both cameras end, high up on a steep wall, all
// weights do. Builds in its constructor; after that immutable.

#include <array>
#include <unordered_map>
#include <vector>

#include "algorithms/bowl/bisected_mesh.h"
#include "algorithms/bowl/pair_sights.h"

namespace svchain::bowl {

struct ShownTriangle {
  std::array<int, 3> corner;  // places of the mesh
  int pair = 0;               // whose quarter it lies in
  int alone = -1;             // the one camera it shows, -1: both of the pair
};

class MeshRefinement {
 public:
  /// All free of faults.
  MeshRefinement(const geometry::Rig& rig, const BowlSurface& surface, const synthesis::BlendShape& shape,
                 double tolerance_px);

  const BisectedMesh& mesh() const { return mesh_; }
  /// What is to be drawn.
  std::vector<ShownTriangle> shown() const;
  const PairSight& sight(int pair, int place) const { return sights_at_[pair].at(place); }
  /// The weight of a pair's first camera that triangles with both show at a place. It is 255 or 0 where the
  /// place is a corner of one that shows the first or the second alone because the other does not see it
  /// whole: so no step shows between them.
  int first_weight(int pair, int place) const;

 private:
  enum Cover { kNone, kFirst, kSecond, kBoth };

  int pair_of(const BisectedMesh::Triangle& triangle) const;
  const PairSight& sight_of(int pair, int place);
  Cover cover(const BisectedMesh::Triangle& triangle, int pair) const;
  bool too_large(const BisectedMesh::Triangle& triangle);
  bool is_off(const BisectedMesh::Triangle& triangle, int pair, Cover cover) const;
  bool is_off_at(const BisectedMesh::Triangle& triangle, int pair, Cover cover,
                 const Eigen::Vector3d& parts) const;
  void hold_weights();

  PairSights sights_;
  double tolerance_px_;
  double least_m_, least_at_border_m_;
  BisectedMesh mesh_;
  std::array<std::unordered_map<int, PairSight>, 4> sights_at_;  // by pair, then by place
  std::array<std::unordered_map<int, int>, 4> held_weights_;
};

}  // namespace svchain::bowl
