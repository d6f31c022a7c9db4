#include <algorithm>
#include <limits>

#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/real_sets.h"
#include "usecases/svchain_accuracy/trial.h"

namespace svchain::accuracy {

namespace {

constexpr int kRuns = 7;
constexpr double kLimitMs = 1000;

using Stages = std::vector<std::pair<std::string, double>>;

double sum_ms(const Stages& stages) {
  double sum = 0;
  for (const auto& [name, ms] : stages) sum += ms;
  return sum;
}

Stages fastest(const calibration::CalibrationInput& input) {
  Stages best;
  for (int run = 0; run < kRuns; ++run) {
    const Stages stages = calibrate(input).stage_ms;
    if (best.empty() || sum_ms(stages) < sum_ms(best)) best = stages;
  }
  return best;
}

void add_column(const std::string& name, const Stages& stages, Table& table) {
  table.head.push_back(name);
  for (size_t i = 0; i < stages.size(); ++i) {
    if (table.head.size() == 2) table.rows.push_back({stages[i].first});
    table.rows[i].push_back(figure(stages[i].second));
  }
  if (table.head.size() == 2) table.rows.insert(table.rows.end(), {{"**all**"}, {"within 1 s"}});
  const double all_ms = sum_ms(stages);
  table.rows[stages.size()].push_back(figure(all_ms));
  table.rows[stages.size() + 1].push_back(met(all_ms, kLimitMs));
}

}  // namespace

Section stage_times(const std::filesystem::path& data) {
  Table table{{"stage, ms"}, {}};
  add_column("simulated car, 1280x720", fastest(input_of(trial_scene("car", "kannala_brandt", 1))), table);
  if (const auto input = read_carpet(data)) add_column("real carpet, 960x640", fastest(*input), table);
  if (const auto input = read_garage(data)) add_column("real garage, 1280x720", fastest(*input), table);
  return {"Time",
          "All four cameras on one core, from pictures in memory to the judged rig: the fastest of " +
              std::to_string(kRuns) + " runs, wall clock.\n",
          {table}};
}

}  // namespace svchain::accuracy
