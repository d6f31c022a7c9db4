#pragma once
// Two ways to do the same thing, measured side by side: turn and turn about, so that whatever else the
// machine does meets both alike, and judged by the median over the rounds of the ratio within a round. Plain
// values; one thread.

#include <functional>
#include <vector>

namespace svchain::bench {

/// Does the thing once (or many times) and returns what it costs, in any unit.
using Cost = std::function<double()>;

struct Paired {
  double ratio = 0;                        // median over the rounds of a / b
  double quarter = 0, three_quarters = 0;  // of the same ratios: half of the rounds lie between
  double a = 0, b = 0;                     // median costs
};

/// The middle value; the mean of the two middle ones where their number is even. Throws std::invalid_argument
/// for none.
double median(std::vector<double> values);
/// The value below which a share of all lies, 0 to 1, interpolated. Throws std::invalid_argument for none.
double quantile(std::vector<double> values, double share);

/// Even rounds begin with a, odd ones with b. Throws std::invalid_argument for less than one round.
Paired measure_paired(int rounds, const Cost& a, const Cost& b);

}  // namespace svchain::bench
