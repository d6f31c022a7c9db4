#pragma once
// The parameters of geometric alignment, and what they stand for: files read, charts found, faults told.
// Called while configuring.

#include <cstddef>
#include <string>
#include <vector>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/view.h"
#include "algorithms/synthesis/blend_shape.h"
#include "framework/link/link.h"

namespace svchain {

struct AlignmentSettings {
  std::string source = "rig";  // rig, nominal, saved, charts or features
  geometry::Rig rig;           // the true one, or the nominal one to start from
  geometry::View view;
  synthesis::BlendShape shape;
  bool from_content = false;  // starts from what the pictures show of the charts, not from the rig's poses
  std::vector<calibration::Chart> charts;  // source charts, or where it starts from content
  std::vector<std::byte> saved;            // source saved: the LUT
  std::string store;                       // where to put the LUT, or ""

  bool looks_at_frames() const { return source == "charts" || source == "features"; }
};

std::vector<ParameterDescription> alignment_parameters();

/// What is wrong becomes a fault of the configuration; the settings then are only good for going on.
AlignmentSettings read_alignment_settings(Configuration& configuration);

}  // namespace svchain
