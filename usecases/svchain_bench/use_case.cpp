#include <stdexcept>

#include "framework/chain/chain.h"
#include "framework/link/wrapped_link.h"
#include "links/builtin_links.h"
#include "links/configs_folder.h"
#include "usecases/svchain_bench/faults.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/surround_view.h"
#include "usecases/svchain_bench/threaded_run.h"

namespace svchain::bench {

namespace {

struct Run {
  std::vector<int64_t> displayed_ns;
  std::vector<double> latency_ms;
};

/// Notes when the link was called, and how old its frame was.
class Noted final : public WrappedLink {
 public:
  Noted(std::unique_ptr<Link> link, Run& run) : WrappedLink(std::move(link)), run_(run) {}
  void process(Call& call) override {
    run_.latency_ms.push_back(static_cast<double>(call.now_ns() - call.input(0).captured_ns()) * 1e-6);
    link().process(call);
    run_.displayed_ns.push_back(now_ns());
  }

 private:
  Run& run_;
};

Plan plan_of(const UseCase& wanted, const ParkedCar& car, const Catalogue& catalogue) {
  std::vector<Override> overrides = {
      {"input=" + car.folder().string()}, {"rig=" + car.rig_file().string()}, {"output=none"}};
  for (const std::string& set : wanted.sets) overrides.push_back({set});
  auto use_case = value_or_throw(
      read_use_case(share_folder() / "usecases" / (wanted.name + ".json"), catalogue, overrides));
  auto soc = value_or_throw(read_soc(configs_folder() / "socs" / (use_case.soc + ".json")));
  return value_or_throw(make_plan(std::move(use_case), std::move(soc), catalogue));
}

Run run(const UseCase& use_case, const ParkedCar& car, const Pace& pace) {
  Catalogue catalogue;
  add_builtin_links(catalogue);
  Plan plan = plan_of(use_case, car, catalogue);
  Run run;
  run.displayed_ns.reserve(*pace.frames);
  run.latency_ms.reserve(*pace.frames);
  for (PlannedLink& link : plan.links) {
    if (link.entry.type == "display") link.link = std::make_unique<Noted>(std::move(link.link), run);
  }
  run_on_threads(std::move(plan), pace);
  return run;
}

}  // namespace

double use_case_frame_ms(const ParkedCar& car, int frames, const UseCase& use_case) {
  constexpr int kUntilInStride = 5;
  Pace pace;
  pace.frames = static_cast<uint64_t>(frames + kUntilInStride);
  const std::vector<int64_t> displayed_ns = run(use_case, car, pace).displayed_ns;
  return static_cast<double>(displayed_ns.back() - displayed_ns[kUntilInStride - 1]) * 1e-6 / frames;
}

double use_case_latency_p99_ms(const ParkedCar& car, double fps, int frames) {
  constexpr int kUntilInStride = 30;  // the LUT is made on the first frames, and later ones queue behind it
  Pace pace;
  pace.real_time = true;
  pace.fps = fps;
  pace.frames = static_cast<uint64_t>(frames + kUntilInStride);
  const std::vector<double> latency_ms = run({}, car, pace).latency_ms;
  if (latency_ms.size() <= kUntilInStride) throw std::runtime_error("hardly a frame was displayed in time");
  return quantile({latency_ms.begin() + kUntilInStride, latency_ms.end()}, 0.99);
}

}  // namespace svchain::bench
