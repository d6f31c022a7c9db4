#include "algorithms/synthesis/kernel.h"

#include <array>

#include "algorithms/synthesis/vector_stages.h"

namespace svchain::synthesis {
namespace {

constexpr std::array kSlowestFirst = {Kernel::kPortable, Kernel::kNeon, Kernel::kAvx2, Kernel::kAvx512};

}  // namespace

const std::vector<std::string>& kernel_names() {
  static const std::vector<std::string> kNames = {"portable", "avx2", "avx512", "neon"};
  return kNames;
}

const std::string& name_of(Kernel kernel) {
  return kernel_names()[static_cast<size_t>(kernel)];
}

bool can_run(Kernel kernel) {
  return kernel == Kernel::kPortable || vector_stages(kernel) != nullptr;
}

std::vector<Kernel> runnable_kernels() {
  std::vector<Kernel> runnable;
  for (const Kernel kernel : kSlowestFirst)
    if (can_run(kernel)) runnable.push_back(kernel);
  return runnable;
}

Kernel best_kernel() {
  Kernel best = Kernel::kPortable;
  for (const Kernel kernel : kSlowestFirst)
    if (can_run(kernel)) best = kernel;
  return best;
}

Result<Kernel> kernel_named(const std::string& name) {
  std::vector<std::string> runnable;
  for (const Kernel kernel : runnable_kernels()) {
    if (name_of(kernel) == name) return kernel;
    runnable.push_back(name_of(kernel));
  }
  const std::string nearest = did_you_mean(name, kernel_names());
  for (const std::string& known : kernel_names())
    if (known == name)
      return fail("", "this processor does not run kernel \"" + name + "\", only " + spoken_list(runnable));
  return fail("", "there is no kernel \"" + name + "\", expected " + spoken_list(kernel_names()) + nearest);
}

}  // namespace svchain::synthesis
