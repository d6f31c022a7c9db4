#include "usecases/svchain/placements.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "framework/chain/modelled_time.h"
#include "framework/chain/run.h"

namespace svchain::program {

namespace {

// 2 s of them to settle. A core that has 0.1 % too much to do loses a frame only every 33 s at 30 fps.
constexpr double kAfterPowerUp_s = 62;
const std::string kDsp = "C66x", kEve = "EVE", kGraphics = "SGX";
const std::set<std::string> kForAlgorithms = {kDsp, kEve, kGraphics};

/// The kind of core that the file puts it on, if that may change.
std::optional<std::string> kind_of_movable(const LinkEntry& link, const Soc& home) {
  const SocCore* core = home.find(link.core);
  if (!core || !kForAlgorithms.contains(core->kind) || link.type == "dup") return std::nullopt;
  return core->kind;
}

std::vector<std::string> cores_for(const LinkEntry& link, const std::string& kind, const Soc& soc) {
  std::vector<std::string> cores;
  for (const SocCore& core : soc.cores) {
    const bool draws = kind == kGraphics && core.kind == kGraphics;
    const bool computes = kind != kGraphics &&
                          (core.kind == kDsp || (core.kind == kEve && soc.costs.has_call(kEve, link.type)));
    if (draws || computes) cores.push_back(core.name);
  }
  return cores;
}

/// Says how many links are elsewhere now.
int place(UseCase& use_case, const Placement& placement) {
  int moved = 0;
  for (const Placed& placed : placement) {
    for (LinkEntry& link : use_case.links) {
      if (link.name == placed.link && std::exchange(link.core, placed.core) != placed.core) ++moved;
    }
  }
  return moved;
}

/// Time for what is done once (of a view's size or not), were it done one after the other, and some more.
double modelled_s(const UseCase& use_case, const Soc& soc) {
  double seconds = kAfterPowerUp_s;
  for (const LinkEntry& link : use_case.links) {
    const SocCore* core = soc.find(link.core);
    if (!core) continue;
    const CallCost& cost = soc.costs.call(core->kind, link.type);
    seconds += (cost.per_result + cost.per_output_px * view_px(use_case)) / (core->clock_mhz * 1e6);
  }
  return seconds;
}

template <class T>
T value_or_throw(Result<T> result) {
  if (result) return std::move(*result);
  throw std::runtime_error(result.error().front().text());
}

}  // namespace

std::vector<Placement> placements(const UseCase& use_case, const Soc& home, const Soc& soc) {
  std::vector<Placement> all = {{}};
  for (const LinkEntry& link : use_case.links) {
    const auto kind = kind_of_movable(link, home);
    if (!kind) {
      if (!soc.find(link.core)) return {};
      continue;
    }
    std::vector<Placement> longer;
    for (const Placement& placement : all) {
      for (const std::string& core : cores_for(link, *kind, soc)) {
        longer.push_back(placement);
        longer.back().push_back({link.name, core});
      }
    }
    all = std::move(longer);
  }
  return all;
}

Judgement judge(UseCase use_case, const Soc& soc, const Catalogue& catalogue, const Placement& placement,
                double fps) {
  Judgement judgement;
  judgement.soc = soc.name;
  judgement.placement = placement;
  judgement.moved = place(use_case, placement);
  ChainOptions options;
  options.execution = Execution::kByHand;
  options.costs = soc.costs;
  options.pace.virtual_clock = options.pace.real_time = true;
  options.pace.pixels = false;
  options.pace.fps = fps;
  options.pace.frames = static_cast<uint64_t>(std::ceil(modelled_s(use_case, soc) * fps));
  Chain chain(value_or_throw(make_plan(std::move(use_case), soc, catalogue)), options);
  if (auto configured = chain.configure(); !configured)
    throw std::runtime_error(configured.error().front().text());
  run_by_hand(chain);
  if (const auto failure = chain.failure()) throw std::runtime_error(failure->text());

  const nlohmann::json report = chain.report();
  const auto after = report.find("after_power_up");
  if (after == report.end()) return judgement;  // nothing was ever delivered
  judgement.holds = (*after)["dropped"] == 0 && (*after)["delivered"] > 0;
  judgement.fps = (*after)["fps"];
  if (after->contains("latency_ms"))
    judgement.latency_p99_ms = (*after)["latency_ms"]["capture_to_display"]["p99"];
  for (const auto& [name, core] : (*after)["cores"].items()) {
    if (const double load = core["load"]; load > judgement.load) {
      judgement.load = load;
      judgement.fullest = name;
    }
  }
  return judgement;
}

bool is_better(const Judgement& a, const Judgement& b) {
  return std::tuple(!a.holds, a.load, a.latency_p99_ms, a.moved) <
         std::tuple(!b.holds, b.load, b.latency_p99_ms, b.moved);
}

}  // namespace svchain::program
