#pragma once
// The parameters of links that make pictures: in which format, and for YUV in which colour encoding; and what
// links that take any format ask of theirs. Called while describing and configuring.

#include <string>
#include <vector>

#include "framework/link/link.h"

namespace svchain {

/// `PREFIXformat` (bgr8, or one of the others) and `PREFIXcolour`.
std::vector<ParameterDescription> picture_parameters(const std::string& prefix,
                                                     const std::vector<std::string>& types);

struct PictureKind {
  std::string type;
  std::string colour;  // "" for bgr8 and bgrx8
};

/// What the parameters say. A colour encoding given for what is not YUV is a fault.
PictureKind picture_kind(Configuration& configuration, const std::string& prefix);

/// Such a picture of this size. One that leaves half a group of chroma is a fault, which calls it `what`.
Format picture_format(Configuration& configuration, const std::string& prefix, const PictureKind& kind,
                      int width_px, int height_px, const std::string& what);

/// Pictures in YUV that come in have a colour encoding that is known; any other is a fault.
void check_colours(Configuration& configuration, int input_port);

}  // namespace svchain
