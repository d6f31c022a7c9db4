#pragma once
// How two neighbouring cameras share the corner between them: by the angle around the vehicle's corner, 45
// degrees being half each, over `width_deg` (0 to 90). 0 is a hard seam: every pixel has one camera, and
// there are no statistics of overlaps. Plain value.

namespace svchain::synthesis {

enum class BlendCurve {
  kSmooth,  // cubic, flat at both ends
  kLinear,
  kBinary,  // the paper's binary decision: every pixel shows one camera, though both are sampled, as smooth
            // would have it; so there are statistics of overlaps
};

struct BlendShape {
  double width_deg = 60;
  BlendCurve curve = BlendCurve::kSmooth;
};

}  // namespace svchain::synthesis
