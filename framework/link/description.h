#pragma once
// What a link says of itself before anything runs: its ports and its parameters. From these the planner
// checks a use case, `svchain list` prints the reference and the JSON schema is made. Plain values.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "algorithms/json/value.h"

namespace svchain {

enum class Kind { kBoolean, kInteger, kNumber, kString, kChoice, kNumbers };

struct ParameterDescription {
  std::string name;
  Kind kind = Kind::kNumber;
  nlohmann::json fallback;  // null: must be given, or is worked out by the link
  json::Range range;        // of a number, an integer, or each item of numbers
  size_t count = 0;         // items of kNumbers
  std::vector<std::string> choices;
  std::string unit;  // "ms", "px", ...; "" for pure numbers
  std::string help;
  bool is_path = false;  // a string that names a file: relative ones may be meant from the use case's folder
};

ParameterDescription boolean(std::string name, bool fallback, std::string help);
ParameterDescription integer(std::string name, long long fallback, json::Range range, std::string unit,
                             std::string help);
ParameterDescription number(std::string name, double fallback, json::Range range, std::string unit,
                            std::string help);
ParameterDescription text(std::string name, std::string fallback, std::string help);
/// A file, absent unless given.
ParameterDescription path(std::string name, std::string help);
ParameterDescription choice(std::string name, std::string fallback, std::vector<std::string> choices,
                            std::string help);

/// How a link takes what comes in at a port.
enum class Intake {
  kEach,   // one frame is consumed by every call
  kState,  // the newest frame is kept and seen by every call; the link waits for the first
};

struct PortDescription {
  std::string name = {};
  std::vector<std::string> types = {};  // accepted or offered; empty: any
  int count = 0;                        // buffers a frame carries; 0: any
  Intake intake = Intake::kEach;        // inputs only
  bool optional = false;                // an input that may be left unconnected
  std::vector<std::string> forwards =
      {};  // outputs only: inputs whose buffers it hands on instead of its own
  std::string help = {};
};

/// When a link is called.
enum class Trigger {
  kAll,  // every kEach input has a frame
  kAny,  // at least one input has a frame: the link itself decides what belongs together
};

struct LinkDescription {
  std::string type;
  std::string help;
  std::vector<PortDescription> inputs;
  std::vector<PortDescription> outputs;
  std::vector<ParameterDescription> parameters;
  Trigger trigger = Trigger::kAll;
  bool delivers = false;  // what this link processes counts as delivered (displays)

  const PortDescription* input(const std::string& name) const;
  const PortDescription* output(const std::string& name) const;
};

}  // namespace svchain
