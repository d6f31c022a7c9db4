#include "usecases/svchain_bench/paired.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace svchain::bench {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) throw std::invalid_argument("a quantile of no values");
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<size_t>(at);
  const size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], at - std::floor(at));
}

double median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

Paired measure_paired(int rounds, const Cost& a, const Cost& b) {
  if (rounds < 1) throw std::invalid_argument("a comparison of no rounds");
  std::vector<double> costs_a, costs_b, ratios;
  for (int round = 0; round < rounds; ++round) {
    const bool a_first = round % 2 == 0;
    if (a_first) costs_a.push_back(a());
    costs_b.push_back(b());
    if (!a_first) costs_a.push_back(a());
    ratios.push_back(costs_a.back() / costs_b.back());
  }
  return {median(ratios), quantile(ratios, 0.25), quantile(ratios, 0.75), median(costs_a), median(costs_b)};
}

}  // namespace svchain::bench
