// What the links of a use case take on this machine, as relative figures for modelled time: the chain is run
// on one thread, a few rounds at several sizes of the view, and the medians of each type of link become a
// CallCost (cost_fit.h). One link, the anchor, has its figure in the SoC's cost model: its cycles there over
// its nanoseconds here make cycles of all others.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "links/capture/frame_source.h"
#include "usecases/svchain/chain_run.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/cost_fit.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/timed_link.h"
#include "usecases/svchain/whole_file.h"
#include "usecases/svchain_page/machine.h"

namespace svchain::program {

namespace {

using Json = nlohmann::json;

constexpr uint64_t kFrames = 12;
constexpr int kRounds = 5;
constexpr size_t kSizes = 4;
constexpr std::array<double, kSizes> kAreas = {1, 0.5, 0.7, 1.4};  // of the view's, the view itself first
constexpr size_t kFewestCalls = 3;                                 // that a median is taken of
constexpr double kShortest_ns =
    10'000;  // what is shorter is mostly caches that the links before have emptied
constexpr const char* kGraphics = "SGX";

/// All links of one type on one kind of core.
struct LinkTimes {
  std::string type, core_kind;
  bool is_source = false;
  std::array<CallTimes, kSizes> by_size;
};

struct Typical {
  CallWork work;
  double median_ns = 0;
  double share = 0;  // of all calls
};

struct Finding {
  const LinkTimes* times = nullptr;
  std::string left_out;  // why there is no figure, "" where there is
  Typical call;
  CostFit fit;
};

double median_of(std::vector<int64_t> ns) {
  const auto middle = ns.begin() + static_cast<std::ptrdiff_t>(ns.size() / 2);
  std::nth_element(ns.begin(), middle, ns.end());
  return static_cast<double>(std::max<int64_t>(1, *middle));
}

std::vector<double> scaled(const std::vector<double>& size_px, double area) {
  std::vector<double> result;
  for (const double px : size_px) result.push_back(area == 1 ? px : std::round(px * std::sqrt(area) / 2) * 2);
  return result;
}

const SocCore& core_of(const Plan& plan, const PlannedLink& link) {
  return plan.cores[static_cast<size_t>(link.core)];
}

LinkTimes& times_of(std::vector<LinkTimes>& all, const Plan& plan, const PlannedLink& link) {
  const std::string& kind = core_of(plan, link).kind;
  for (LinkTimes& times : all) {
    if (times.type == link.entry.type && times.core_kind == kind) return times;
  }
  return all.emplace_back(LinkTimes{link.entry.type, kind, link.description.inputs.empty(), {}});
}

/// One run at one size. What went wrong, or nothing.
std::optional<std::string> run_once(PlannedUseCase planned, const RunNumbers& numbers, HostLoop& host,
                                    size_t size, std::vector<LinkTimes>& all) {
  Parameters& view = planned.plan.use_case.settings.at("view");
  view.put("size_px", scaled(view.numbers("size_px"), kAreas[size]));
  for (const PlannedLink& link : planned.plan.links) times_of(all, planned.plan, link);  // none moves later
  for (PlannedLink& link : planned.plan.links) {
    CallTimes& times = times_of(all, planned.plan, link).by_size[size];
    link.link = std::make_unique<TimedLink>(std::move(link.link), planned.plan, link, times);
  }
  ChainOptions options;
  options.pace = numbers.pace;
  options.execution = Execution::kByHand;
  options.on_finished = [&host] { host.finish(); };
  Chain chain(std::move(planned.plan), std::move(options));
  Faults faults;
  configure(chain, faults);
  if (!faults.empty()) return faults.front().text();
  run_to_its_end(chain, host, numbers, numbers.pace);
  if (const auto failure = chain.failure()) return failure->text();
  return std::nullopt;
}

/// The commonest call that sends something, else the commonest. Those that send nothing come first.
std::optional<Typical> typical_of(const CallTimes& times) {
  size_t calls = 0, most = 0;
  const CallTimes::value_type* commonest = nullptr;
  for (const auto& entry : times) {
    calls += entry.second.size();
    const bool first_to_send = commonest && entry.first.sent && !commonest->first.sent;
    if (!first_to_send && entry.second.size() <= most) continue;
    commonest = &entry;
    most = entry.second.size();
  }
  if (!commonest) return std::nullopt;
  return Typical{commonest->first, median_of(commonest->second),
                 static_cast<double>(most) / static_cast<double>(calls)};
}

std::vector<MeasuredCalls> medians_of(const LinkTimes& times) {
  std::vector<MeasuredCalls> medians;
  for (const CallTimes& calls : times.by_size) {
    for (const auto& [work, ns] : calls) {
      if (ns.size() < kFewestCalls) continue;
      medians.push_back({work.sent, static_cast<double>(work.input_px), static_cast<double>(work.output_px),
                         median_of(ns)});
    }
  }
  return medians;
}

Finding finding_of(const LinkTimes& times) {
  Finding finding{&times, {}, {}, {}};
  const auto medians = medians_of(times);
  const auto call = typical_of(times.by_size.front());
  if (call) finding.call = *call;
  if (times.is_source) {
    finding.left_out = "a source: what it does here is not what cameras do";
  } else if (times.core_kind == kGraphics) {
    finding.left_out = "drawn by graphics: a CPU says nothing about it";
  } else if (!call) {
    finding.left_out = "never ran";
  } else if (call->median_ns < kShortest_ns) {
    finding.left_out = "too short to measure, less than 10 us";
  } else if (medians.empty()) {
    finding.left_out = "ran too seldom";
  } else {
    finding.fit = fit_cost(medians);
  }
  return finding;
}

/// Five digits: there are not more in it.
double rounded(double v) {
  if (v == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(v)) - 4);
  return unit < 1 ? std::round(v / unit) / std::round(1 / unit) : std::round(v / unit) * unit;
}

/// The link that everything is measured by, as the SoC's cost model has it.
struct Anchor {
  std::string type, core_kind;
  CallCost cost;
};

std::optional<Anchor> anchor_of(const Plan& plan, const std::string& name, Faults& faults) {
  std::vector<std::string> names;
  for (const PlannedLink& link : plan.links) {
    names.push_back(link.entry.name);
    if (link.entry.name != name && link.entry.type != name) continue;
    const std::string &type = link.entry.type, &kind = core_of(plan, link).kind;
    if (plan.soc.costs.has_call(kind, type)) return Anchor{type, kind, plan.soc.costs.call(kind, type)};
    faults.push_back({"--anchor",
                      {},
                      {},
                      plan.soc.name + " has no figure for " + type + " on " + kind +
                          ", expected a link that it has one for"});
    return std::nullopt;
  }
  faults.push_back({"--anchor",
                    {},
                    {},
                    "there is no link \"" + name + "\"" + did_you_mean(name, names) +
                        " (links: " + spoken_list(names) + ")"});
  return std::nullopt;
}

double cycles_of(const CallCost& cost, const CallWork& work) {
  return cost.cycles(work.sent, static_cast<double>(work.input_px), static_cast<double>(work.output_px));
}

bool is_anchor(const Finding& finding, const Anchor& anchor) {
  return finding.times->type == anchor.type && finding.times->core_kind == anchor.core_kind;
}

/// On this kind of core.
CallCost cost_of(const Finding& finding, const std::string& kind, const Anchor& anchor, double cycles_per_ns,
                 const Soc& soc) {
  if (is_anchor(finding, anchor)) return anchor.cost;
  CallCost cost = finding.fit.cost_ns;
  for (double CallCost::*term :
       {&CallCost::per_call, &CallCost::per_result, &CallCost::per_input_px, &CallCost::per_output_px})
    cost.*term = rounded(cost.*term * cycles_per_ns);
  cost.basis = "measured on " + page::processor() + ", " + page::compiler() + ", relative to " + anchor.type;
  if (kind != anchor.core_kind) cost.basis += "; cycles taken to be those of " + anchor.core_kind;
  if (!soc.costs.has_call(kind, finding.times->type)) return cost;
  const CallCost& known = soc.costs.call(kind, finding.times->type);
  cost.bytes_per_input_px = known.bytes_per_input_px;
  cost.bytes_per_output_px = known.bytes_per_output_px;
  if (cost.bytes_per_input_px + cost.bytes_per_output_px > 0) cost.basis += "; bytes as in " + soc.name;
  return cost;
}

void show(const std::vector<Finding>& findings, const Anchor& anchor, double cycles_per_ns,
          double anchor_cycles) {
  std::printf("%-22s  %-6s  %12s  %12s  %9s  %s\n", "link", "on", "ns a call", "cycles", "of anchor",
              "fit off by at most");
  for (const Finding& f : findings) {
    std::printf("%-22s  %-6s  ", f.times->type.c_str(), f.times->core_kind.c_str());
    if (!f.left_out.empty()) {
      std::printf("left out: %s\n", f.left_out.c_str());
      continue;
    }
    const double cycles = is_anchor(f, anchor) ? anchor_cycles : f.call.median_ns * cycles_per_ns;
    std::printf("%12.0f  %12.0f  %7.2f %%  %4.1f %%", f.call.median_ns, cycles, 100 * cycles / anchor_cycles,
                100 * f.fit.largest_deviation);
    if (is_anchor(f, anchor)) std::printf("  the anchor");
    if (f.call.share < 0.5) std::printf("  in %.0f %% of its calls", 100 * f.call.share);
    std::printf("\n");
  }
}

/// Repeats all sizes in turn: what the machine does besides hits them all alike.
int measure(const ProfileOptions& options, const RunNumbers& numbers, HostLoop& host,
            std::vector<LinkTimes>& all) {
  for (int round = 0; round < kRounds; ++round) {
    for (size_t i = 0; i < kSizes; ++i) {
      const size_t size = round % 2 == 0 ? i : kSizes - 1 - i;
      auto planned = plan_use_case(options.use_case);
      if (!planned) return say(planned.error());
      if (all.empty()) all.reserve(planned->plan.links.size());
      const auto failed = run_once(std::move(*planned), numbers, host, size, all);
      if (host.interrupted()) return kInterrupted;
      if (!failed) continue;
      std::cerr << "svchain: error: " << *failed << '\n';
      return kFailed;
    }
  }
  return kDone;
}

int write_costs(const std::vector<LinkTimes>& all, const Anchor& anchor, const Soc& soc,
                const std::string& path) {
  std::vector<Finding> findings;
  for (const LinkTimes& times : all) findings.push_back(finding_of(times));
  const auto measured_anchor =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return is_anchor(f, anchor); });
  const double anchor_cycles = cycles_of(anchor.cost, measured_anchor->call.work);
  if (!measured_anchor->left_out.empty() || anchor_cycles <= 0) {
    const std::string why =
        measured_anchor->left_out.empty() ? "costs nothing on " + soc.name : measured_anchor->left_out;
    std::cerr << "svchain: error: " << anchor.type << " is no anchor: " << why << '\n';
    return kFailed;
  }
  const double cycles_per_ns = anchor_cycles / measured_anchor->call.median_ns;
  Json file;
  for (const Finding& f : findings) {
    if (f.left_out.empty())
      file["costs"]["cycles"][f.times->core_kind][f.times->type] =
          to_file_json(cost_of(f, f.times->core_kind, anchor, cycles_per_ns, soc));
  }
  for (const Finding& f : findings) {  // the anchor's kind is the one the cycles are really of
    Json& links = file["costs"]["cycles"][anchor.core_kind];
    if (f.left_out.empty() && !links.contains(f.times->type))
      links[f.times->type] = to_file_json(cost_of(f, anchor.core_kind, anchor, cycles_per_ns, soc));
  }
  show(findings, anchor, cycles_per_ns, anchor_cycles);
  write_whole(path, file.dump(2) + "\n");
  return kDone;
}

}  // namespace

int profile(const ProfileOptions& options) {
  prepare_libraries();
  Faults faults = check_writable(options.output, "--output");
  RunNumbers numbers;
  numbers.pace.virtual_clock = true;  // by hand on one thread: no link waits for, or disturbs, another
  numbers.pace.frames = read_whole_number("--frames", options.frames, {3, 1e6}, faults).value_or(kFrames);
  ProfileOptions quiet = options;
  quiet.use_case.output = "none";
  const auto planned = plan_use_case(quiet.use_case);
  if (!planned) {
    append(faults, planned.error());
    return say(faults);
  }
  const Plan& plan = planned->plan;
  const std::string input = setting_text(plan.use_case, "input");
  if (is_live_source(input)) {
    faults.push_back({"--input", {}, {}, "is live and never the same again, expected files or a scene"});
  } else {
    numbers.pace = pace_for(input, numbers, faults);
  }
  append(faults, rig_faults(plan.use_case));
  const auto anchor = anchor_of(plan, options.anchor, faults);
  if (!faults.empty()) return say(faults);

  HostLoop host;
  std::vector<LinkTimes> all;
  if (const int status = measure(quiet, numbers, host, all); status != kDone) return status;
  return write_costs(all, *anchor, plan.soc, options.output);
}

}  // namespace svchain::program
