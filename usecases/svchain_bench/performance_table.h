#pragma once
// What is measured, what beside, and which figure is aimed at; and the tables of docs/performance.md that say
// what came out. Pure functions.

#include <optional>
#include <string>
#include <vector>

#include "usecases/svchain_bench/results.h"
#include "usecases/svchain_page/document.h"

namespace svchain::bench {

struct Goal {
  enum class Sense { kAtLeast, kAtMost } sense = Sense::kAtLeast;
  double limit = 0;

  bool met(double value) const;
  /// "at least 6".
  std::string text() const;
};

/// The largest cost per pixel, over the output's sizes, may be this many times the smallest.
inline constexpr Goal kPixelCostGoal{Goal::Sense::kAtMost, 1.2};

/// A ratio or a figure of Results.
struct Subject {
  std::string name, beside;
  std::optional<Goal> goal;
};

/// All ratios whose names begin so: those known here, measured or not, and then whatever else was measured.
std::vector<Subject> ratios_of(const Results& results, const std::string& prefix);
std::vector<Subject> figures_of(const Results& results);

/// "synthesis.avx512.1t" is the other's cost over ours; "hop.spin_park_rtt_over_raw_ring" ours over the
/// other's.
bool is_ours_over_other(const std::string& name);

/// "yes", "**no**", or "" for no goal.
std::string verdict(const std::optional<Goal>& goal, double value);

/// Costs in the unit of the measurement.
page::Table ratio_table(const Results& results, const std::string& prefix, const std::string& unit);
page::Table figure_table(const Results& results);

struct Tally {
  int goals = 0;
  std::vector<std::string> missed, not_measured;  // names
};
Tally tally_of(const Results& results);

}  // namespace svchain::bench
