#pragma once
// The numbers among the options.

#include "algorithms/json/fault.h"
#include "algorithms/json/value.h"
#include "framework/link/link.h"
#include "usecases/svchain/commands.h"

namespace svchain::program {

struct RunNumbers {
  Pace pace;                     // as far as the options say
  std::optional<double> fps;     // --fps: in real time, at this rate
  std::optional<uint64_t> seed;  // --seed: the order in which a virtual run steps its cores, and of faults
};

/// All of the text, within the range; nothing where there is no text, and a fault where it is something else.
std::optional<uint64_t> read_whole_number(const std::string& option, const std::optional<std::string>& text,
                                          const json::Range& range, Faults& faults);

/// The same for any number.
std::optional<double> read_number(const std::string& option, const std::optional<std::string>& text,
                                  const json::Range& range, Faults& faults);

/// A rate in frames/s.
std::optional<double> read_fps(const std::optional<std::string>& text, Faults& faults);

/// Bad ones become faults.
RunNumbers read_numbers(const RunOptions& options, Faults& faults);

}  // namespace svchain::program
