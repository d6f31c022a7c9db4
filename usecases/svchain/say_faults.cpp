#include "usecases/svchain/say_faults.h"

#include <iostream>
#include <set>

#include "usecases/svchain/exit_status.h"

namespace svchain::program {

int say(const Faults& faults) {
  std::set<std::string> said;
  for (const Fault& fault : faults) {
    const std::string line = fault.text();
    if (said.insert(line).second) std::cerr << line << '\n';
  }
  return kBadUsage;
}

}  // namespace svchain::program
