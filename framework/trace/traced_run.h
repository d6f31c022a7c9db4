#pragma once
// A run that was traced: what the cores have recorded, and the names of what they speak of. Borrows the
// recorders of the chain that it is of. One thread, when the chain has stopped.

#include <string>
#include <vector>

#include "framework/trace/recorder.h"

namespace svchain {

struct TracedEdge {
  std::string name;
  int to_link = 0;
  int capacity = 0;  // messages that may wait there
  bool crosses = false;
};

struct TracedRun {
  std::string use_case, soc;
  bool modelled = false;                   // under the virtual clock
  std::vector<std::string> cores;          // in the SoC's order
  std::vector<std::string> links;          // in the use case's order
  std::vector<std::string> delivering;     // those of the links that deliver
  std::vector<TracedEdge> edges;           // in the use case's order
  std::vector<const Recorder*> recorders;  // by core; none where nothing was traced
};

}  // namespace svchain
