#pragma once
// Faults as the user sees them: one line each on stderr, the same one only once.

#include "algorithms/json/fault.h"

namespace svchain::program {

/// Returns the exit status that goes with faults.
int say(const Faults& faults);

inline void append(Faults& faults, const Faults& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

template <class T>
Faults faults_of(const Result<T>& result) {
  return result ? Faults{} : result.error();
}

}  // namespace svchain::program
