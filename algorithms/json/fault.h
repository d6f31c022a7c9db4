#pragma once
// What is wrong with what a user gave us, and where. Plain values, any thread.

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace svchain {

struct Location {
  int line = 0;  // 1-based; 0: the fault has no place in a text
  int column = 0;
};

struct Fault {
  std::string file;  // a file, or an option such as "--input"
  Location where;
  std::string pointer;  // JSON pointer of the value at fault, may be empty
  std::string message;  // what, expected, nearest valid name

  /// `FILE:LINE:COLUMN: error: /json/pointer: message`, leaving out what is not known.
  std::string text() const;
};

using Faults = std::vector<Fault>;

/// A value, or every fault that was found on the way to it.
template <class T>
using Result = tl::expected<T, Faults>;

/// A single fault as the failed half of a Result.
tl::unexpected<Faults> fail(std::string file, std::string message);

/// `names` joined as a reader would say them: "a, b or c".
std::string spoken_list(const std::vector<std::string>& names);

/// ", did you mean "x"?" for the nearest of `names` by edit distance, or "" where none is near.
std::string did_you_mean(const std::string& given, const std::vector<std::string>& names);

}  // namespace svchain
