// Which placement of a use case's algorithms holds a rate, on which SoC, found in modelled time.

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "framework/chain/modelled_time.h"
#include "usecases/svchain/chain_run.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/largest_view.h"
#include "usecases/svchain/placements.h"
#include "usecases/svchain/run_numbers.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/shipped_files.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kUsualFps = 30;

struct Candidate {
  const Soc* soc = nullptr;
  Placement placement;
};

std::string text_of(const Placement& placement) {
  std::string text;
  for (const Placed& placed : placement) text += (text.empty() ? "" : ", ") + placed.link + " " + placed.core;
  return text;
}

/// One chain per thread; the order of the results does not depend on who was faster.
std::vector<Judgement> judge_all(const RequestedUseCase& requested, const std::vector<Candidate>& candidates,
                                 double fps) {
  std::vector<Judgement> judgements(candidates.size());
  std::atomic<size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failed;
  const auto work = [&] {
    for (size_t i; (i = next++) < candidates.size();) {
      try {
        judgements[i] =
            judge(requested.use_case, *candidates[i].soc, *requested.catalogue, candidates[i].placement, fps);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failed = std::current_exception();
      }
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned t = std::max(1U, std::thread::hardware_concurrency()); t > 0; --t) threads.emplace_back(work);
  threads.clear();
  if (failed) std::rethrow_exception(failed);
  std::stable_sort(judgements.begin(), judgements.end(), is_better);
  return judgements;
}

void show(const std::vector<Judgement>& judgements) {
  std::printf("%-8s  %-5s  %6s  %-12s  %10s  %s\n", "soc", "holds", "fps", "fullest core", "p99 ms",
              "placement");
  for (const Judgement& j : judgements) {
    const std::string fullest = j.fullest.empty() ? "-" : j.fullest;
    std::printf("%-8s  %-5s  %6.2f  %-6s %3.0f %%  %10.2f  %s\n", j.soc.c_str(), j.holds ? "yes" : "no",
                j.fps, fullest.c_str(), 100 * j.load, j.latency_p99_ms, text_of(j.placement).c_str());
  }
}

std::string text_of(const ViewSize& size) {
  return std::to_string(size.width_px) + " x " + std::to_string(size.height_px) + " px";
}

std::string text_of(const ViewLimit& limit) {
  if (!limit.holds) return "none, not even " + text_of(*limit.drops) + ", where " + limit.cause + " is full";
  if (!limit.drops) return text_of(*limit.holds) + ", and larger there is none";
  const std::string cause = limit.cause.empty() ? "nothing comes through" : limit.cause + " is full";
  return text_of(*limit.holds) + "; at " + text_of(*limit.drops) + " " + cause;
}

/// For the best placement on every SoC, in their order.
void show_limits(const RequestedUseCase& requested, const std::vector<Soc>& socs,
                 const std::vector<Judgement>& judgements, double fps) {
  std::printf("\nlargest view that holds %g frames/s, as placed best\n", fps);
  for (const Soc& soc : socs) {
    const auto best = std::find_if(judgements.begin(), judgements.end(),
                                   [&](const Judgement& j) { return j.soc == soc.name; });
    if (best == judgements.end()) continue;
    const ViewLimit limit = largest_view(requested.use_case, soc, *requested.catalogue, best->placement, fps);
    std::printf("%-8s  %s  (%s)\n", soc.name.c_str(), text_of(limit).c_str(),
                text_of(best->placement).c_str());
  }
}

/// "LINK.PARAMETER=VALUE" or "SETTING.KEY=VALUE", as the file would say it.
void write_override(Json& use_case, const std::string& text) {
  const size_t equals = text.find('='), dot = text.substr(0, equals).find('.');
  const std::string name = text.substr(0, std::min(dot, equals)), value_text = text.substr(equals + 1);
  Json value = Json::parse(value_text, nullptr, false);
  if (value.is_discarded()) value = value_text;
  if (dot == std::string::npos) {
    use_case[name] = value;
    return;
  }
  const std::string key = text.substr(dot + 1, equals - dot - 1);
  const bool is_link = use_case["links"].contains(name);
  (is_link ? use_case["links"][name]["params"] : use_case[name])[key] = value;
}

void write_best(const RequestedUseCase& requested, const ExploreOptions& options, const Judgement& best) {
  std::ifstream in(requested.use_case.file);
  Json use_case = Json::parse(in);
  use_case["soc"] = options.soc.value_or(best.soc);
  for (const std::string& set : options.use_case.sets) write_override(use_case, set);
  for (const Placed& placed : best.placement) use_case["links"][placed.link]["core"] = placed.core;
  write_whole(*options.output, use_case.dump(2) + "\n");
}

/// The one that is asked for, else all that are shipped.
std::vector<Soc> socs_to_try(const ExploreOptions& options, Faults& faults) {
  std::vector<Soc> socs;
  const auto names = options.soc ? std::vector{*options.soc} : shipped_names(kSocs);
  for (const std::string& name : names) {
    auto soc = read_soc_said(name, {"--soc", {}, {}}, options.use_case.costs);
    if (soc) {
      socs.push_back(std::move(*soc));
    } else {
      append(faults, soc.error());
    }
  }
  return socs;
}

/// Any core may be tried, so all need a clock.
Faults clock_faults(const Soc& soc) {
  Plan plan;
  plan.soc.name = soc.name;
  plan.cores = soc.cores;
  return what_cannot_be_modelled(plan);
}

}  // namespace

int explore(const ExploreOptions& options) {
  prepare_libraries();
  Faults faults;
  if (options.output) append(faults, check_writable(*options.output, "--output"));
  const double fps = read_fps(options.fps, faults).value_or(kUsualFps);
  const auto requested = read_requested(options.use_case);
  if (!requested) append(faults, requested.error());
  if (!faults.empty()) return say(faults);

  const auto home = read_soc_said(requested->use_case.soc, requested->use_case.soc_origin);
  const std::vector<Soc> socs = socs_to_try(options, faults);
  if (!home) append(faults, home.error());
  for (const Soc& soc : socs) append(faults, clock_faults(soc));
  if (!faults.empty()) return say(faults);
  std::vector<Candidate> candidates;
  for (const Soc& soc : socs) {
    for (Placement& placement : placements(requested->use_case, *home, soc))
      candidates.push_back({&soc, std::move(placement)});
  }
  if (candidates.empty())
    return say({{requested->use_case.file, {}, {}, "no SoC has a place for all links"}});
  const auto judgements = judge_all(*requested, candidates, fps);
  show(judgements);
  show_limits(*requested, socs, judgements, fps);
  if (options.output) write_best(*requested, options, judgements.front());
  return kDone;
}

}  // namespace svchain::program
