#pragma once
// Which instructions synthesis runs on. Every kernel gives the same bytes (fixed_point.h, colour/yuv.h) and
// the same statistics; they differ in speed alone. "portable" is plain C++ and the reference. The others need
// their processor: "avx2", "avx512" (Ice Lake or Zen 4 and later, for its permutes of bytes) and "neon".
// Choice is a value that goes with the call, so different ones may run side by side. Any thread.

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/json/fault.h"

namespace svchain::synthesis {

enum class Kernel : uint8_t { kPortable, kAvx2, kAvx512, kNeon };

/// In the order of Kernel.
const std::vector<std::string>& kernel_names();
const std::string& name_of(Kernel kernel);

/// What this processor runs, slowest first; never empty.
std::vector<Kernel> runnable_kernels();
bool can_run(Kernel kernel);
/// The fastest that this processor runs.
Kernel best_kernel();

/// The kernel of that name. Faults name the nearest name, or what this processor has instead.
Result<Kernel> kernel_named(const std::string& name);

}  // namespace svchain::synthesis
