#pragma once
// What a runner has to know of faults: those of its link, of its core, and of what a source gives on its
// outputs. Belongs to the link's core.

#include <optional>
#include <vector>

#include "framework/fault/core_faults.h"
#include "framework/fault/recovery.h"
#include "framework/fault/source_faults.h"

namespace svchain {

struct LinkFaults {
  FaultSite& link;
  CoreFaults& core;
  std::vector<std::optional<SourceFaults>> outputs;  // by port; of sources
  bool gives_parts = false;                          // of sets that are made of them further on
  Recovery* recovery = nullptr;                      // of a link that delivers
  bool takes_time = false;                           // a slow call has to wait for its time to pass
};

}  // namespace svchain
