#pragma once
// Runs one link alone, on one thread, without a chain: give it parameters, formats and frames, and look at
// what it sends. For tests of links; the link is called by the very code that calls it in a chain.
//
//   LinkHarness sync(make_sync());
//   sync.parameter("delta_ms", 10);
//   for (auto camera : {"front", "right", "rear", "left"}) sync.input(camera, {Format::bgr8(4, 4)});
//   REQUIRE(sync.configure().empty());
//   sync.push("front", {.sequence = 0, .timestamp_ns = 0});
//   sync.run();
//   auto set = sync.pop("frames");
//
// Not thread-safe. Frames that pop() returns must go before the harness does.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/buffer/frame.h"
#include "framework/clock/clock.h"
#include "framework/link/link.h"

namespace svchain::testing {

struct Push {
  uint64_t sequence = 0;
  int64_t timestamp_ns = 0;
  int64_t captured_ns = 0;
  std::function<void(int buffer, std::span<std::byte> bytes)> write =
      {};               // may be empty: the bytes are left as they are
  bool absent = false;  // the frame was lost upstream
};

class LinkHarness {
 public:
  explicit LinkHarness(std::unique_ptr<Link> link);
  ~LinkHarness();

  Link& link();
  Pace pace;

  void parameter(const std::string& name, nlohmann::json value);
  /// A plain setting ("rig") or a key of a group ("view", "metres_per_px").
  void setting(const std::string& name, nlohmann::json value) { setting(name, "value", std::move(value)); }
  void setting(const std::string& group, const std::string& key, nlohmann::json value);
  /// Connects an input. An input whose format is never given stays unconnected.
  void input(const std::string& port, PortFormat format, int depth = 64);
  /// Leaves an output unconnected (they are all connected otherwise), or limits what it takes.
  void disconnect(const std::string& output_port);
  void output_depth(const std::string& output_port, int depth);

  /// Calls the link's configure() and start(); where a required input has no format, check() alone.
  Faults configure();
  const PortFormat& output_format(const std::string& port) const;

  void push(const std::string& port, const Push& push);
  void push_end(const std::string& port);
  /// Calls the link as long as it is ready, at most `calls` times; returns how often it was called.
  int run(int calls = 1000);
  std::optional<Frame> pop(const std::string& port);
  /// An absence or the end stands at the head of what an output sent (and is taken away).
  bool pop_absence(const std::string& port);
  bool pop_end(const std::string& port);
  void stop();

  VirtualClock& clock();
  /// When a source wants to be called next.
  int64_t wake_time_ns() const;
  uint64_t processed() const;
  uint64_t captured() const;
  std::map<std::string, uint64_t> dropped() const;
  /// What a call that threw said ("" if none).
  std::string failure() const;
  /// Buffers of the link's own pools that are not free.
  size_t buffers_in_use() const;
  nlohmann::json report() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace svchain::testing
