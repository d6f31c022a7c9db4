#pragma once
// Rigs' lenses as other programs write them. Their files hold neither poses, the vehicle nor a largest angle;
// lenses that they have no model for are faults which name camera and model.

#include <string>
#include <vector>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

struct TextFile {
  std::string name;
  std::string text;
};

/// camchain.yaml, cam0 to cam3 being front, right, rear, left. Holds kannala_brandt, pinhole without k3, mei,
/// eucm and double_sphere.
Result<std::vector<TextFile>> export_kalibr(const Rig& rig);
/// A camera_info YAML named for each camera. Holds kannala_brandt and pinhole.
Result<std::vector<TextFile>> export_ros(const Rig& rig);

}  // namespace svchain::geometry
