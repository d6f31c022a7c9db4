#pragma once
// The figures of the cost model (cost_model.h) that explain best what calls took:
//
//   time = per_call + per_result, if the call has sent anything
//          + per_input_px * input pixels + per_output_px * output pixels,   none of them negative,
//
// by least squares over relative deviations. What measurements cannot tell apart (pixels that are as many in
// every call, input and output that are the same) is told by the fewest figures: a further one has to earn
// its place. Pure functions, any thread.

#include <cstdint>
#include <vector>

#include "framework/usecase/cost_model.h"

namespace svchain::program {

/// Calls that had the same to do, counted as the cost model counts it.
struct MeasuredCalls {
  bool sent = false;
  double input_px = 0, output_px = 0;
  double median_ns = 0;
};

struct CostFit {
  CallCost cost_ns;              // nanoseconds where the cost model has cycles; no bytes
  double largest_deviation = 0;  // relative, of the fit from what was measured
};

/// All times are above 0; at least one.
CostFit fit_cost(const std::vector<MeasuredCalls>& measured);

}  // namespace svchain::program
