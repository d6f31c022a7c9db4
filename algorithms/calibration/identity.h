#pragma once
// Which part of which chart a fragment may be, by its pattern alone: the fragment, turned by quarters and
// shifted, has to lie on the chart's corners, dark on dark. Pure.

#include <vector>

#include "algorithms/calibration/charts.h"
#include "algorithms/calibration/fragments.h"

namespace svchain::calibration {

/// A chart with its corners at hand.
struct ChartPattern {
  Chart chart;
  std::vector<ChartCorner> corners;
};

std::vector<ChartPattern> patterns_of(const std::vector<Chart>& charts);

struct Identity {
  size_t chart = 0;
  std::vector<int> corner;  // of the chart, for every corner of the fragment; -1: it has none there
  double score = 0;         // corners that agree, less those that should be there and are not
};

/// Best first; only what explains at least most of the fragment.
std::vector<Identity> identities(const Fragment& fragment, const std::vector<ChartPattern>& patterns);

}  // namespace svchain::calibration
