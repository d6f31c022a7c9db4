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

/// Runs it with stderr on a terminal, calls `reached` with what it has said there so far, and sends the
/// signal once that is true. `err` is what the terminal showed.
Outcome svchain_interrupted(const Arguments& arguments, int signal,
                            const std::function<bool(const std::string&)>& reached);

}  // namespace svchain::testing
