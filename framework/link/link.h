#pragma once
// A link: the unit of work in a chain. It says what it is (describe), agrees on formats (configure), and
// turns frames in into frames out (process). It sees neither queues nor cores nor threads.
//
// Life: describe, configure, start, process*, finish, stop; then configure again or destruction.
// Threads: describe and configure on the caller's thread before the chain runs; everything else on the link's
// core, one call at a time. No call may block: a link is called when its inputs and the room downstream are
// there. Errors: configure returns faults through Configuration::fault; process may throw, the framework adds
// link and sequence and does what the use case says ("on_error": "stop" or "drop").

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "algorithms/json/fault.h"
#include "framework/buffer/format.h"
#include "framework/link/description.h"
#include "framework/link/parameters.h"

namespace svchain {

class Call;

/// How the run as a whole goes.
struct Pace {
  bool real_time = false;  // frames come when the clock says so, and what is late is dropped
  bool virtual_clock =
      false;        // time is modelled: sources keep their nominal rate, and never drop unless real_time
  double fps = 30;  // nominal rate of time stamps, and of capture in real time
  std::optional<uint64_t> frames;  // sets to capture; nothing: as the source has
  uint64_t seed = 1;
  bool pixels = true;  // false: timing alone; links send what they would send and neither read nor write it
};

/// What a link is given, and says, while it is configured. Borrowed for the call.
class Configuration {
 public:
  virtual ~Configuration() = default;

  virtual const std::string& link_name() const = 0;
  virtual const Parameters& parameters() const = 0;
  /// A setting shared by the links of the use case ("view", "rig", "input", "output"), checked and complete.
  virtual const Parameters& setting(const std::string& name) const = 0;
  virtual const Pace& pace() const = 0;
  /// Format at an input; empty where the input is unconnected or its edge is feedback.
  virtual const PortFormat& input(int port) const = 0;
  virtual bool output_connected(int port) const = 0;

  /// What an output will carry. Outputs that forward say what they forward.
  virtual void output(int port, PortFormat format) = 0;
  /// Frames from this input that the link keeps beyond a call, at most (default: none).
  virtual void holds(int input_port, int frames) = 0;
  /// The link writes all of this output's buffers once and sends them again and again: the pool has exactly
  /// so many.
  virtual void preloaded(int output_port, int buffers) = 0;
  /// The link wants to be called when its time comes though downstream has no room, and asks Call::room
  /// itself.
  virtual void calls_without_room() = 0;

  /// Something is wrong. `what` says what, expected, came.
  virtual void fault(std::string what) = 0;
  /// The same for a parameter of the link: the fault stands at its place in the use case.
  virtual void parameter_fault(const std::string& parameter, std::string what) = 0;
  /// The same for a format: `field` is "type", "buffers", "width_px", ...; both ports are named.
  virtual void format_fault(int input_port, std::string field, std::string expected, std::string got) = 0;
  /// Passes on faults of a file.
  virtual void faults(const Faults& found) = 0;
};

class Link {
 public:
  virtual ~Link() = default;

  virtual LinkDescription describe() const = 0;
  virtual void configure(Configuration& configuration) = 0;
  /// Called instead of configure() where a link upstream has faults, so that what comes in is unknown: says
  /// what is wrong all the same (files, paths), for all faults are to be shown at once.
  virtual void check(Configuration&) {}
  virtual void start() {}
  virtual void process(Call& call) = 0;
  /// All inputs have ended: sends what is left, as far as there is room, and returns true when nothing is
  /// left.
  virtual bool finish(Call&) { return true; }
  /// A command while running, between two calls. Returns the answer; throws std::invalid_argument on a bad
  /// one.
  virtual nlohmann::json control(const std::string& command, const nlohmann::json& arguments);
  virtual void stop() {}
  /// Once configured, and after the run: adds the link's own part to the report ("view", "photometric",
  /// "output"), and to its array "warnings" what the user should know without asking for a report, as text
  /// that begins with the link's name. The program says each once.
  virtual void report(nlohmann::json&) const {}
};

using LinkFactory = std::function<std::unique_ptr<Link>()>;

}  // namespace svchain
