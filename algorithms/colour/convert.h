#pragma once
// Whole pictures from BGR to YUV and back, by the arithmetic of yuv.h. Writes into the caller's memory and
// allocates nothing; pictures must not overlap. Throws std::invalid_argument where sizes differ, formats are
// not what the name says, or NV12 or YUYV would have half a group. Any thread.

#include "algorithms/colour/picture.h"

namespace svchain::colour {

/// NV12 or YUYV as `yuv` says. A group's chroma is that of its pixels' mean, 2x2 or 2x1.
void yuv_from_bgr(const Picture& bgr, const Picture& yuv);

/// A pixel's chroma is its group's, replicated.
void bgr_from_yuv(const Picture& yuv, const Picture& bgr);

/// What a picture of any format shows.
void bgr_from(const Picture& picture, const Picture& bgr);

}  // namespace svchain::colour
