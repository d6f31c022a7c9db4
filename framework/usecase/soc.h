#pragma once
// The cores of a system on chip and what work costs there, as a SoC file lists them. Plain values.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "algorithms/json/fault.h"
#include "framework/usecase/cost_model.h"

namespace svchain {

constexpr int kMostCpus = 64;

struct SocCore {
  std::string name;  // "DSP1"
  std::string kind;  // "C66x", "A15", "M4", "EVE", "SGX"
  double clock_mhz = 0;
  std::string clock_basis;  // where the clock is published, or what the file notes of it: "clock assumed"
  int count = 1;            // identical cores behind one name: A15 x2
  int cpus = 1;             // threads that its links may share their work among
  int spins = 200;          // how often the simulated core looks at its doorbell before it parks
  bool parks = true;        // false: it never sleeps, which needs a CPU of its own
};

struct Soc {
  std::string name;  // "tda2x"
  std::string title;
  std::vector<SocCore> cores;
  std::map<std::string, std::string> roles;  // "host" -> "A15"
  CostModel costs;

  /// The core a name or a role stands for; null if there is none.
  const SocCore* find(const std::string& core_or_role) const;
  std::vector<std::string> core_names() const;
};

Result<Soc> read_soc(const std::filesystem::path& path);
Result<Soc> parse_soc(const std::string& text, const std::string& file);

}  // namespace svchain
