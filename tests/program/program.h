#pragma once
// The program, run as a user runs it.

#include <filesystem>
#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace svchain::testing {

struct Outcome {
  int status = -1;  // 128 + signal where one ended it
  std::string out, err;
};

using Arguments = std::vector<std::string>;

/// Runs it to its end.
Outcome svchain_program(const Arguments& arguments);

/// A signal to send once `reached` is true of what the program has said so far.
struct TimedSignal {
  int signal = 0;
  std::function<bool(const std::string&)> reached;
};

/// Runs it with stderr on a terminal, and sends one signal after the other. `err` is what the terminal
/// showed.
Outcome svchain_signalled(const Arguments& arguments, const std::vector<TimedSignal>& signals);
Outcome svchain_interrupted(const Arguments& arguments, int signal,
                            const std::function<bool(const std::string&)>& reached);

}  // namespace svchain::testing
