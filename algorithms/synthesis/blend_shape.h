#pragma once
// How two neighbouring cameras share the corner between them: by the angle around the vehicle's corner, 45
// degrees being half each, with a smooth fall-off over `width_deg` (0 to 90). 0 is a binary decision: every
// pixel has one camera, and there are no statistics of overlaps. Plain value.

namespace svchain::synthesis {

struct BlendShape {
  double width_deg = 60;
};

}  // namespace svchain::synthesis
