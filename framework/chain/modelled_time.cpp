#include "framework/chain/modelled_time.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/chain/runtime.h"

namespace svchain {

namespace {

using Json = nlohmann::json;

constexpr int64_t kSettling_ns = 2'000'000'000;

const SocCore& core_of(const Plan& plan, int link) {
  return plan.cores[static_cast<size_t>(plan.links[static_cast<size_t>(link)].core)];
}

double share(int64_t busy_ns, int64_t of_ns) {
  if (of_ns <= 0) return 0;
  return std::round(static_cast<double>(busy_ns) / static_cast<double>(of_ns) * 1e4) / 1e4;
}

}  // namespace

ModelledTime::ModelledTime(const Plan& plan, const CostModel& costs, Chain::Runtime& runtime)
    : plan_(plan),
      costs_(costs),
      runtime_(runtime),
      view_px_(view_px(plan.use_case)),
      in_flight_(plan.cores.size()) {
  const bool named = some_link_delivers(plan);
  for (size_t l = 0; l < plan.links.size(); ++l) {
    const PlannedLink& link = plan.links[l];
    const SocCore& core = core_of(plan, static_cast<int>(l));
    const bool delivers = named ? link.description.delivers : link.description.outputs.empty();
    prices_[runtime.runners[l].get()] = {costs.call(core.kind, link.entry.type), 1e3 / core.clock_mhz,
                                         delivers};
  }
}

bool ModelledTime::step(const Core::Choice& choice) {
  const size_t count = in_flight_.size();
  const int64_t now_ns = runtime_.clock->now_ns();
  for (size_t c = 0; c < count; ++c) {
    if (in_flight_[c].runner && in_flight_[c].end_ns <= now_ns) end(c);
  }
  for (const auto& core : runtime_.cores) core->look_at_faults(now_ns);
  const size_t first = choice ? choice(count) : 0;
  for (size_t i = 0; i < count; ++i) {
    const size_t c = (first + i) % count;
    if (in_flight_[c].runner) continue;
    Runner* runner = runtime_.cores[c]->next(choice);
    if (!runner) continue;
    begin(c, *runner);
    return true;
  }
  return false;
}

bool ModelledTime::advance() {
  std::optional<int64_t> earliest_ns;
  const auto may_be = [&](std::optional<int64_t> time_ns) {
    if (time_ns && (!earliest_ns || *time_ns < *earliest_ns)) earliest_ns = time_ns;
  };
  for (size_t c = 0; c < in_flight_.size(); ++c) {
    if (in_flight_[c].runner) may_be(in_flight_[c].end_ns);
    may_be(in_flight_[c].runner ? runtime_.cores[c]->next_fault_ns() : runtime_.cores[c]->next_wake_ns());
  }
  for (const auto& edge : runtime_.edges) may_be(edge->next_arrival_ns());
  if (!earliest_ns) return false;
  runtime_.virtual_clock->advance_to(*earliest_ns);
  for (const auto& edge : runtime_.edges) edge->tell_if_arrived();
  return true;
}

void ModelledTime::begin(size_t core, Runner& runner) {
  const int64_t now_ns = runtime_.clock->now_ns();
  const Runner::Work work = runner.begin_call(now_ns);
  InFlight& call = in_flight_[core];
  call = {&runner, now_ns, now_ns, false};
  call.end_ns += runner.slowed_ns(duration_ns(prices_.at(&runner), work, call.moves_bytes));
  if (call.end_ns == now_ns) end(core);
}

void ModelledTime::end(size_t core) {
  const InFlight call = std::exchange(in_flight_[core], {});
  const bool delivered = call.runner->in_call() && prices_.at(call.runner).delivers;
  call.runner->end_call(call.end_ns);
  runtime_.cores[core]->count_call(call.end_ns - call.begin_ns);
  if (delivered) note_delivery(call.runner->captured_ns());
}

int64_t ModelledTime::duration_ns(const Priced& priced, const Runner::Work& work, bool& moves_bytes) const {
  if (!work.called) return 0;
  const CallCost& cost = priced.cost;
  const auto input_px = static_cast<double>(work.input_px);
  const double output_px = work.sent && work.output_px == 0 ? view_px_ : static_cast<double>(work.output_px);
  const double cycles = cost.cycles(work.sent, input_px, output_px);
  const double bytes = cost.bytes_per_input_px * input_px + cost.bytes_per_output_px * output_px;
  moves_bytes = bytes > 0 && costs_.memory.bytes_per_s > 0;
  double memory_ns = 0;
  if (moves_bytes) {  // this call is among those in flight
    const auto sharing = std::count_if(in_flight_.begin(), in_flight_.end(),
                                       [](const InFlight& c) { return c.runner && c.moves_bytes; });
    memory_ns = bytes / costs_.memory.bytes_per_s * 1e9 * static_cast<double>(sharing);
  }
  return std::llround(std::max(cycles * priced.ns_per_cycle, memory_ns));
}

void ModelledTime::note_delivery(int64_t captured_ns) {
  const int64_t now_ns = runtime_.clock->now_ns();
  if (!first_delivery_ns_) first_delivery_ns_ = now_ns;
  if (!power_up_) {
    if (now_ns >= *first_delivery_ns_ + kSettling_ns) end_power_up();
    return;
  }
  delivered_after_.add();
  if (captured_ns >= power_up_->end_ns) latency_after_.record(now_ns - captured_ns);
}

void ModelledTime::end_power_up() {
  const int64_t now_ns = runtime_.clock->now_ns();
  power_up_ = {now_ns, dropped_count(plan_, runtime_), {}};
  for (size_t c = 0; c < in_flight_.size(); ++c) {
    const int64_t so_far_ns = in_flight_[c].runner ? now_ns - in_flight_[c].begin_ns : 0;
    power_up_->busy_ns.push_back(runtime_.cores[c]->busy_ns() + so_far_ns);
  }
}

Json ModelledTime::what_it_rests_on() const {
  Json rests;
  for (size_t l = 0; l < plan_.links.size(); ++l) {
    const SocCore& core = core_of(plan_, static_cast<int>(l));
    Json& link = rests["links"][plan_.links[l].entry.name];
    link = to_json(costs_.call(core.kind, plan_.links[l].entry.type));
    link["core_kind"] = core.kind;
    link["clock_mhz"] = core.clock_mhz;
    link["clock_basis"] = core.clock_basis;
  }
  rests["ipc"] = Json::object();
  for (const PlannedEdge& edge : plan_.edges) {
    if (!edge.ipc) continue;
    const std::string &from = core_of(plan_, edge.from_link).kind, &to = core_of(plan_, edge.to_link).kind;
    const IpcCost& hop = costs_.hop(from, to);
    rests["ipc"][from + " -> " + to] = {{"latency_us", hop.latency_us}, {"basis", hop.basis}};
  }
  if (costs_.memory.bytes_per_s > 0)
    rests["memory"] = {{"bytes_per_s", costs_.memory.bytes_per_s}, {"basis", costs_.memory.basis}};
  return rests;
}

void ModelledTime::report(Json& report, int64_t end_ns) const {
  report["clock"] = "virtual";
  report["modelled"] = what_it_rests_on();
  for (const auto& edge : runtime_.edges) report["edges"][edge->name()]["high_water"] = edge->high_water();
  if (!power_up_) return;
  const int64_t lasted_ns = end_ns - power_up_->end_ns;
  Json& after = report["after_power_up"];
  const auto since_start_s = [&](int64_t ns) {
    return static_cast<double>((ns - runtime_.started_ns) / 1000) / 1e6;
  };
  after["first_delivery_s"] = since_start_s(*first_delivery_ns_);
  after["from_s"] = since_start_s(power_up_->end_ns);
  after["delivered"] = delivered_after_.value();
  after["dropped"] = dropped_count(plan_, runtime_) - power_up_->dropped;
  const double lasted_s = std::max(1e-9, static_cast<double>(lasted_ns) * 1e-9);
  after["fps"] = std::round(static_cast<double>(delivered_after_.value()) / lasted_s * 1e3) / 1e3;
  if (latency_after_.count() > 0) after["latency_ms"]["capture_to_display"] = in_ms(latency_after_);
  for (size_t c = 0; c < in_flight_.size(); ++c) {
    const Core& core = *runtime_.cores[c];
    after["cores"][core.name()]["load"] = share(core.busy_ns() - power_up_->busy_ns[c], lasted_ns);
  }
}

double view_px(const UseCase& use_case) {
  const auto view = use_case.settings.find("view");
  if (view == use_case.settings.end()) return 0;
  const std::vector<double> size_px = view->second.numbers("size_px");
  return size_px.size() == 2 ? size_px[0] * size_px[1] : 0;
}

Faults what_cannot_be_modelled(const Plan& plan) {
  Faults faults;
  for (const SocCore& core : plan.cores) {
    if (core.clock_mhz > 0) continue;
    faults.push_back({plan.soc.name,
                      {},
                      "/cores/" + core.name,
                      "\"clock_mhz\" is missing: without it no call there can be modelled"});
  }
  return faults;
}

}  // namespace svchain
