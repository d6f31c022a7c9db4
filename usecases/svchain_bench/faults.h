#pragma once
// Faults as exceptions: what is measured is known to be right, and a fault is the end of the measurement.

#include <stdexcept>

#include "algorithms/json/fault.h"

namespace svchain::bench {

inline void value_or_throw(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().front().text());
}

template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().front().text());
  return std::move(*result);
}

}  // namespace svchain::bench
