#pragma once
// What a configured chain is made of. Private to framework/chain.

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "framework/chain/chain.h"
#include "framework/chain/core.h"
#include "framework/chain/edge.h"
#include "framework/chain/modelled_time.h"
#include "framework/fault/chain_faults.h"
#include "ipc/shared_region.h"

namespace svchain {

struct Chain::Runtime {
  std::unique_ptr<Clock> clock;
  VirtualClock* virtual_clock = nullptr;  // the same, if it is one

  ipc::SharedRegion doorbells_region;
  std::vector<ipc::Doorbell*> doorbells;  // by core, in the region
  std::vector<std::unique_ptr<Core>> cores;
  std::vector<std::unique_ptr<Recorder>> recorders;  // by core; none: no trace
  ipc::SharedRegion returns_region;
  std::vector<std::unique_ptr<ReturnPath>> return_paths;  // by core
  std::unique_ptr<ChainFaults> faults;                    // null: nothing goes wrong
  std::vector<Pool*> spare_pools;                         // by edge, where a source damages pictures
  PoolTable pools;
  std::vector<std::unique_ptr<Holder>> holders;  // by link
  std::vector<std::unique_ptr<Edge>> edges;      // by planned edge
  std::vector<std::unique_ptr<Runner>> runners;  // by link
  std::vector<int> position;                     // of a link on its core

  std::vector<std::thread> threads;
  std::vector<std::unique_ptr<Workers>>
      workers;                 // of the cores that have more than one CPU, while threads run
  bool links_started = false;  // at least one: stop() has something to do
  bool all_started = false;
  int64_t started_ns = 0;
  std::atomic<int64_t> finished_ns{0};  // when the last link ended
  std::atomic<size_t> ended{0};
  std::mutex finished_mutex;
  std::condition_variable finished;
  size_t next_core = 0;                    // by hand: whose turn it is
  std::unique_ptr<ModelledTime> modelled;  // by hand, with a cost model
};

/// What the links said when they were configured.
struct LinkSetup {
  std::vector<PortFormat> outputs;
  std::vector<int> holds;
  std::vector<int> preloaded;
  bool calls_without_room = false;
};

/// Configures every link, source to sink, and checks the formats of the feedback edges afterwards.
Result<std::vector<LinkSetup>> configure_links(Plan& plan, const Pace& pace);

/// Buffers that an output port needs: its edge's depth and whatever lies behind that keeps frames, and one to
/// write.
size_t buffers_needed(const Plan& plan, const std::vector<LinkSetup>& setups, int link, int port);

/// A link says that it delivers; where none does, every sink counts as one that does.
bool some_link_delivers(const Plan& plan);
/// An edge into a link that makes sets of what comes.
bool carries_parts(const Plan& plan, const PlannedEdge& edge);
/// Sets lost on their way to delivery.
uint64_t dropped_count(const Plan& plan, const Chain::Runtime& runtime);
nlohmann::json in_ms(const Histogram& durations);

/// Buffers that an edge and everything behind it can hold at a time; 0 for none (-1).
size_t held_behind(const Plan& plan, const std::vector<LinkSetup>& setups, int edge);
/// Where sources damage pictures. Before the buffers' ways home are laid.
void build_spare_pools(const Plan& plan, const std::vector<LinkSetup>& setups, Chain::Runtime& runtime);
/// The runtime being complete but for its faults.
void build_faults(const Plan& plan, const ChainOptions& options, Chain::Runtime& runtime);

/// Makes cores, pools, edges and runners. Throws std::system_error where memory is short.
std::unique_ptr<Chain::Runtime> build_runtime(Plan& plan, const std::vector<LinkSetup>& setups,
                                              const ChainOptions& options, const Runner::Hooks& hooks);

}  // namespace svchain
