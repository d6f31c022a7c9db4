// The report of a run, as contracts for other people's scripts have it.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/chain/runtime.h"

namespace svchain {

namespace {

using Json = nlohmann::json;

/// To so many parts of one; dividing at the end gives the shortest decimal.
double rounded(double v, double parts) {
  return std::round(v * parts) / parts;
}

Json in_us(const Histogram& h) {
  const auto us = [](int64_t ns) { return rounded(static_cast<double>(ns) * 1e-3, 1e3); };
  return {{"p50", us(h.quantile_ns(0.5))}, {"p99", us(h.quantile_ns(0.99))}};
}

void add_counts(std::map<std::string, uint64_t>& sum, const std::map<std::string, uint64_t>& more) {
  for (const auto& [reason, count] : more) sum[reason] += count;
}

struct Deliveries {
  uint64_t delivered = 0;
  const Histogram* latency = nullptr;
};

/// What the delivering links have processed (every sink where none says that it delivers); the fewest counts.
Deliveries deliveries(const Plan& plan, const Chain::Runtime& r) {
  const bool named = some_link_delivers(plan);
  Deliveries d;
  for (size_t l = 0; l < plan.links.size(); ++l) {
    const LinkDescription& description = plan.links[l].description;
    if (named ? !description.delivers : !description.outputs.empty()) continue;
    const RunnerCounters& counters = r.runners[l]->counters();
    if (d.latency && counters.processed.value() >= d.delivered) continue;
    d = {counters.processed.value(), &counters.latency};
  }
  return d;
}

/// Sets lost on their way to delivery, by reason.
std::map<std::string, uint64_t> dropped_sets(const Plan& plan, const Chain::Runtime& r) {
  std::map<std::string, uint64_t> dropped;
  for (size_t l = 0; l < plan.links.size(); ++l) {
    if (plan.links[l].on_main_way) add_counts(dropped, r.runners[l]->counters().dropped.by_reason());
  }
  for (size_t e = 0; e < plan.edges.size(); ++e) {
    if (!plan.edges[e].on_main_way) continue;
    std::map<std::string, uint64_t> on_edge = r.edges[e]->dropped().by_reason();
    if (carries_parts(plan, plan.edges[e])) {
      on_edge.erase("dropout");  // what of a set goes wrong before it is one, its maker counts
      on_edge.erase(kLostOnEdge);
    }
    add_counts(dropped, on_edge);
  }
  for (const auto& runner : r.runners) {
    for (const auto& [reason, count] : runner->counters().counted_twice.by_reason()) dropped[reason] -= count;
  }
  std::erase_if(dropped, [](const auto& entry) { return entry.second == 0; });
  return dropped;
}

Json frames_part(const Plan& plan, const Chain::Runtime& r, uint64_t delivered) {
  uint64_t captured = 0;
  for (const auto& runner : r.runners) captured += runner->counters().captured.value();
  std::map<std::string, uint64_t> dropped = dropped_sets(plan, r);
  uint64_t accounted = delivered;
  for (const auto& [reason, count] : dropped) accounted += count;
  if (captured > accounted)
    dropped["unfinished"] = captured - accounted;  // on their way when the run was cut short
  return {{"captured", captured}, {"delivered", delivered}, {"dropped", dropped}};
}

}  // namespace

bool some_link_delivers(const Plan& plan) {
  return std::any_of(plan.links.begin(), plan.links.end(),
                     [](const PlannedLink& l) { return l.description.delivers; });
}

bool carries_parts(const Plan& plan, const PlannedEdge& edge) {
  return plan.links[static_cast<size_t>(edge.to_link)].description.trigger == Trigger::kAny;
}

uint64_t dropped_count(const Plan& plan, const Chain::Runtime& r) {
  uint64_t sum = 0;
  for (const auto& [reason, count] : dropped_sets(plan, r)) sum += count;
  return sum;
}

Json in_ms(const Histogram& h) {
  const auto ms = [](int64_t ns) { return rounded(static_cast<double>(ns) * 1e-6, 1e4); };
  return {{"p50", ms(h.quantile_ns(0.5))}, {"p99", ms(h.quantile_ns(0.99))}, {"max", ms(h.max_ns())}};
}

Progress Chain::progress() const {
  Progress progress;
  progress.delivered = deliveries(plan_, *runtime_).delivered;
  progress.dropped = dropped_count(plan_, *runtime_);
  return progress;
}

nlohmann::json Chain::report() const {
  Json report = {{"usecase", plan_.use_case.name}, {"soc", plan_.soc.name}};
  if (!runtime_) return report;
  const Runtime& r = *runtime_;
  const int64_t end_ns = r.finished_ns != 0 ? r.finished_ns.load() : r.clock->now_ns();
  const double wall_s = std::max(1e-9, static_cast<double>(end_ns - r.started_ns) * 1e-9);
  const Deliveries d = deliveries(plan_, r);
  report["frames"] = frames_part(plan_, r, d.delivered);
  report["wall_s"] = rounded(wall_s, 1e6);
  report["fps"] = rounded(static_cast<double>(d.delivered) / wall_s, 1e3);
  if (d.latency) report["latency_ms"]["capture_to_display"] = in_ms(*d.latency);

  report["cores"] = Json::object();
  for (const auto& core : r.cores) {
    report["cores"][core->name()]["load"] =
        rounded(static_cast<double>(core->busy_ns()) * 1e-9 / wall_s, 1e4);
  }
  for (size_t l = 0; l < plan_.links.size(); ++l) {
    const RunnerCounters& c = r.runners[l]->counters();
    Json& link = report["links"][plan_.links[l].entry.name];
    link = {{"core", plan_.cores[static_cast<size_t>(plan_.links[l].core)].name},
            {"processed", c.processed.value()},
            {"process_ms", in_ms(c.process)},
            {"dropped", c.dropped.by_reason()}};
    if (!r.runners[l]->is_source()) link["latency_ms"] = in_ms(c.latency);
    if (c.late_feedback.value() > 0) link["feedback_lost"] = c.late_feedback.value();
  }
  report["edges"] = Json::object();
  for (const auto& edge : r.edges) {
    Json& e = report["edges"][edge->name()];
    e = {{"ipc", edge->ipc()}, {"messages", edge->messages()}, {"full", edge->full()}};
    if (edge->ipc()) e["hop_us"] = in_us(edge->hop());
    if (edge->dropped().total() > 0) e["dropped"] = edge->dropped().by_reason();
  }
  report["pools"] = Json::object();
  for (const auto& pool : r.pools) {
    report["pools"][pool->name()] = {{"buffers", pool->buffers()},
                                     {"buffer_bytes", pool->format().bytes},
                                     {"high_water", pool->high_water()},
                                     {"outstanding_at_stop", pool->buffers() - pool->free()}};
  }
  for (const auto& held : outstanding()) report["pools"][held.pool]["held_by"][held.holder] = held.count;
  if (r.modelled) r.modelled->report(report, end_ns);
  if (r.faults) report["faults"] = r.faults->report();
  for (const auto& runner : r.runners) runner->link().report(report);
  return report;
}

}  // namespace svchain
