#pragma once
// How large the composite can get before a SoC no longer holds a rate: searched by bisection in modelled
// time, at the proportions of the use case's view. Sides are even, as NV12 wants them.

#include <optional>
#include <string>

#include "usecases/svchain/placements.h"

namespace svchain::program {

struct ViewSize {
  int width_px = 0, height_px = 0;
};

struct ViewLimit {
  std::optional<ViewSize> holds;  // the largest; nothing: none does
  std::optional<ViewSize> drops;  // 2 px wider; nothing: the largest view there can be holds too
  std::string cause;              // the fullest core where sets are dropped
};

/// Any thread; throws as judge() does. Takes for granted that what holds a view holds all smaller ones.
ViewLimit largest_view(const UseCase& use_case, const Soc& soc, const Catalogue& catalogue,
                       const Placement& placement, double fps);

}  // namespace svchain::program
