#pragma once
// Catch2 as the distribution has it: version 3 or version 2.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
namespace Catch::Matchers {
inline auto Contains(const std::string& part) {
  return ContainsSubstring(part);
}
}  // namespace Catch::Matchers
#else
#include <catch2/catch.hpp>
#endif
