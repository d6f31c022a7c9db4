#include "usecases/svchain/largest_view.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace svchain::program {

namespace {

constexpr int kSmallest_px = 16, kLargest_px = 8192;  // of a side, as the setting has it

int even(double px) {
  return 2 * static_cast<int>(std::lround(px / 2));
}

}  // namespace

ViewLimit largest_view(const UseCase& use_case, const Soc& soc, const Catalogue& catalogue,
                       const Placement& placement, double fps) {
  const auto size_px = use_case.settings.at("view").numbers("size_px");
  const double height_per_width = size_px[1] / size_px[0];
  const auto size_at = [&](int halves) { return ViewSize{2 * halves, even(2 * halves * height_per_width)}; };
  ViewLimit limit;
  const auto holds = [&](int halves) {
    const ViewSize size = size_at(halves);
    UseCase sized = use_case;
    sized.settings.at("view").put("size_px", {size.width_px, size.height_px});
    const Judgement judgement = judge(std::move(sized), soc, catalogue, placement, fps);
    if (judgement.holds) {
      limit.holds = size;
    } else {
      limit.drops = size;
      limit.cause = judgement.fullest;
    }
    return judgement.holds;
  };

  const double longer = std::max(1.0, height_per_width), shorter = std::min(1.0, height_per_width);
  const int least = static_cast<int>(std::ceil(kSmallest_px / 2 / shorter));
  const int most = static_cast<int>(kLargest_px / 2 / longer);
  // Halved or doubled until the limit lies between: very large views are not tried where there is no need.
  int high = std::clamp(static_cast<int>(size_px[0] / 2), least, most), low = high;
  if (holds(high)) {
    do {
      if (high == most) return limit;
      low = std::exchange(high, std::min(2 * high, most));
    } while (holds(high));
  } else {
    do {
      if (low == least) return limit;
      high = std::exchange(low, std::max(low / 2, least));
    } while (!holds(low));
  }
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return limit;
}

}  // namespace svchain::program
