// Which placement of a use case's algorithms holds a rate, on which SoC, found in modelled time.

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "usecases/svchain/chain_run.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
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

void write_best(const RequestedUseCase& requested, const std::vector<std::string>& sets,
                const Judgement& best, const std::string& path) {
  std::ifstream in(requested.use_case.file);
  Json use_case = Json::parse(in);
  use_case["soc"] = best.soc;
  for (const std::string& set : sets) write_override(use_case, set);
  for (const Placed& placed : best.placement) use_case["links"][placed.link]["core"] = placed.core;
  write_whole(path, use_case.dump(2) + "\n");
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

  std::vector<Soc> socs;
  const Soc* home = nullptr;
  for (const std::string& name : shipped_names(kSocs)) {
    auto soc = shipped_soc(name);
    if (!soc) return say(soc.error());
    socs.push_back(std::move(*soc));
  }
  for (const Soc& soc : socs) {
    if (soc.name == requested->use_case.soc) home = &soc;
  }
  if (!home) return say({requested->use_case.soc_origin.fault("expected a shipped SoC to start from")});
  std::vector<Candidate> candidates;
  for (const Soc& soc : socs) {
    for (Placement& placement : placements(requested->use_case, *home, soc))
      candidates.push_back({&soc, std::move(placement)});
  }
  if (candidates.empty())
    return say({{requested->use_case.file, {}, {}, "no SoC has a place for all links"}});
  const auto judgements = judge_all(*requested, candidates, fps);
  show(judgements);
  if (options.output) write_best(*requested, options.use_case.sets, judgements.front(), *options.output);
  return kDone;
}

}  // namespace svchain::program
