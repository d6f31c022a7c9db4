#include "framework/trace/traced_run.h"

#include "framework/chain/runtime.h"

namespace svchain {

TracedRun Chain::traced() const {
  TracedRun run;
  run.use_case = plan_.use_case.name;
  run.soc = plan_.soc.name;
  if (!runtime_) return run;
  const Runtime& r = *runtime_;
  run.modelled = r.virtual_clock != nullptr;
  for (const SocCore& core : plan_.cores) run.cores.push_back(core.name);
  for (const PlannedLink& link : plan_.links) {
    run.links.push_back(link.entry.name);
    if (link.description.delivers) run.delivering.push_back(link.entry.name);
  }
  for (size_t e = 0; e < plan_.edges.size(); ++e)
    run.edges.push_back(
        {r.edges[e]->name(), plan_.edges[e].to_link, r.edges[e]->capacity(), r.edges[e]->ipc()});
  for (const auto& recorder : r.recorders) run.recorders.push_back(recorder.get());
  return run;
}

}  // namespace svchain
