#include "usecases/svchain_bench/performance_table.h"

#include <algorithm>

namespace svchain::bench {

namespace {

constexpr auto kAtLeast = Goal::Sense::kAtLeast;
constexpr auto kAtMost = Goal::Sense::kAtMost;

const std::vector<Subject>& known_ratios() {
  static const std::vector<Subject> kKnown = {
      {"synthesis.portable.1t", "B", Goal{kAtLeast, 1.3}},
      {"synthesis.avx2.1t", "B", Goal{kAtLeast, 4.5}},
      {"synthesis.avx512.1t", "B", Goal{kAtLeast, 6}},
      {"synthesis.portable.1t_vs_float", "A", {}},
      {"synthesis.avx2.1t_vs_float", "A", {}},
      {"synthesis.avx512.1t_vs_float", "A", {}},
      {"synthesis.nv12.portable.1t", "cvtColor and B", {}},
      {"synthesis.nv12.avx2.1t", "cvtColor and B", {}},
      {"synthesis.nv12.avx512.1t", "cvtColor and B", Goal{kAtLeast, 6}},
      {"synthesis.portable.2t", "B in strips", {}},
      {"synthesis.avx2.2t", "B in strips", {}},
      {"synthesis.avx512.2t", "B in strips", Goal{kAtLeast, 5}},
      {"chain.frames_vs_kernels", "kernels in sequence", Goal{kAtLeast, 0.9}},
      {"chain.frames_vs_opencv_program", "program with B", {}},
      {"hop.spin_park_rtt_over_raw_ring", "ring, spinning", Goal{kAtMost, 1.5}},
      {"hop.parked_rtt_over_raw_futex", "ring with futex", Goal{kAtMost, 1.15}},
      {"hop.ipc_spin_park_rtt_over_raw_ring", "ring, spinning", {}},
      {"hop.ipc_parked_rtt_over_raw_futex", "ring with futex", {}},
      {"hop.stream_vs_asio_post", "asio::post", Goal{kAtLeast, 3}},
      {"hop.ipc_stream_vs_asio_post", "asio::post", {}},
      {"hop.stream_vs_condition_variable", "queue with mutex", {}},
      {"hop.stream_vs_tbb_flow_graph", "TBB function_node", {}},
      {"hop.stream_vs_gstreamer_queue", "GStreamer queue", Goal{kAtLeast, 15}},
  };
  return kKnown;
}

const std::vector<Subject>& known_figures() {
  static const std::vector<Subject> kKnown = {
      {"chain.capture_to_display_p99_ms", "", Goal{kAtMost, 10}},
      {"hop.same_core_ns", "", Goal{kAtMost, 100}},
      {"synthesis.pixel_cost_spread", "", kPixelCostGoal},
      {"bowl.gpu_fps", "", Goal{kAtLeast, 30}},
      {"bowl.gpu_standing_fps", "", {}},
      {"bowl.gpu_nv12_fps", "", {}},
      {"bowl.gpu_upload_ms", "", {}},
      {"bowl.gpu_draw_ms", "", {}},
      {"bowl.gpu_read_back_ms", "", {}},
      {"bowl.gpu_upload_nv12_ms", "", {}},
      {"bowl.gpu_draw_nv12_ms", "", {}},
      {"bowl.cpu_moving_fps", "", Goal{kAtLeast, 30}},
      {"bowl.cpu_static_over_2d", "", Goal{kAtMost, 1.3}},
      {"bowl.viewpoint_lut_ms", "", {}},
      {"bowl.car_ms", "", {}},
      {"bowl.mesh_table_ms", "", {}},
      {"machine.cpus_for_two_threads", "", {}},
  };
  return kKnown;
}

/// Those known that begin so, then what else was measured.
template <class Value>
std::vector<Subject> subjects(const std::vector<Subject>& known, const std::map<std::string, Value>& measured,
                              const std::string& prefix) {
  std::vector<Subject> chosen;
  for (const Subject& subject : known)
    if (subject.name.starts_with(prefix)) chosen.push_back(subject);
  for (const auto& [name, value] : measured) {
    const auto named = [&name = name](const Subject& subject) { return subject.name == name; };
    if (name.starts_with(prefix) && std::none_of(known.begin(), known.end(), named))
      chosen.push_back({name, "", {}});
  }
  return chosen;
}

std::string code(const std::string& name) {
  return "`" + name + "`";
}

std::string goal_text(const Subject& subject) {
  return subject.goal ? subject.goal->text() : "";
}

std::string reason(const Results& results, const std::string& name) {
  const auto found = results.missing.find(name);
  return found == results.missing.end() ? "not measured" : found->second;
}

std::vector<std::string> row_of(const Results& results, const Subject& subject) {
  const auto found = results.ratios.find(subject.name);
  if (found == results.ratios.end())
    return {code(subject.name),
            subject.beside,
            reason(results, subject.name),
            "",
            goal_text(subject),
            "",
            "",
            ""};
  const Paired& paired = found->second;
  const bool ours_first = is_ours_over_other(subject.name);
  return {code(subject.name),
          subject.beside,
          page::figure(paired.ratio),
          page::figure(paired.quarter) + " to " + page::figure(paired.three_quarters),
          goal_text(subject),
          verdict(subject.goal, paired.ratio),
          page::figure(ours_first ? paired.a : paired.b),
          page::figure(ours_first ? paired.b : paired.a)};
}

}  // namespace

bool Goal::met(double value) const {
  return sense == Sense::kAtLeast ? value >= limit : value <= limit;
}

std::string Goal::text() const {
  std::string number = std::to_string(limit);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.pop_back();
  return (sense == Sense::kAtLeast ? "at least " : "at most ") + number;
}

std::vector<Subject> ratios_of(const Results& results, const std::string& prefix) {
  return subjects(known_ratios(), results.ratios, prefix);
}

std::vector<Subject> figures_of(const Results& results) {
  return subjects(known_figures(), results.figures, "");
}

bool is_ours_over_other(const std::string& name) {
  return name.find("_over_") != std::string::npos;
}

std::string verdict(const std::optional<Goal>& goal, double value) {
  return !goal ? "" : goal->met(value) ? "yes" : "**no**";
}

page::Table ratio_table(const Results& results, const std::string& prefix, const std::string& unit) {
  page::Table table{
      {"measured", "beside", "ratio", "half of the rounds", "goal", "met", "ours, " + unit, "other, " + unit},
      {}};
  for (const Subject& subject : ratios_of(results, prefix)) table.rows.push_back(row_of(results, subject));
  return table;
}

page::Table figure_table(const Results& results) {
  page::Table table{{"measured", "figure", "goal", "met"}, {}};
  for (const Subject& subject : figures_of(results)) {
    const auto found = results.figures.find(subject.name);
    const bool measured = found != results.figures.end();
    table.rows.push_back({code(subject.name),
                          measured ? page::figure(found->second) : reason(results, subject.name),
                          goal_text(subject), measured ? verdict(subject.goal, found->second) : ""});
  }
  return table;
}

Tally tally_of(const Results& results) {
  Tally tally;
  const auto count = [&](const Subject& subject, const std::optional<double>& value) {
    if (!subject.goal) return;
    ++tally.goals;
    if (!value)
      tally.not_measured.push_back(code(subject.name));
    else if (!subject.goal->met(*value))
      tally.missed.push_back(code(subject.name));
  };
  for (const Subject& subject : ratios_of(results, "")) {
    const auto found = results.ratios.find(subject.name);
    count(subject, found == results.ratios.end() ? std::nullopt : std::optional(found->second.ratio));
  }
  for (const Subject& subject : figures_of(results)) {
    const auto found = results.figures.find(subject.name);
    count(subject, found == results.figures.end() ? std::nullopt : std::optional(found->second));
  }
  return tally;
}

}  // namespace svchain::bench
