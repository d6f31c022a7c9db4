#pragma once
// From a use case's name to a plan: links of plug-ins, the file, what the command line overrides, the SoC and
// the rig, all read and checked, with every fault at once. One thread.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/link/catalogue.h"
#include "framework/usecase/plan.h"

namespace svchain::program {

/// What a command line says about a use case. Relative paths are meant from the current folder.
struct UseCaseRequest {
  std::string use_case;              // NAME or FILE
  std::string soc;                   // NAME or FILE; "": the use case's own
  std::vector<std::string> sets;     // "LINK.PARAMETER=VALUE"
  std::vector<std::string> plugins;  // shared libraries
  std::optional<std::string> input, output, rig;
  std::optional<std::string> costs;  // FILE with figures that win over those of the SoC
};

/// The catalogue keeps the code of plug-ins loaded: it has to outlive the plan's links.
struct PlannedUseCase {
  std::unique_ptr<Catalogue> catalogue;
  Plan plan;
};

Result<PlannedUseCase> plan_use_case(const UseCaseRequest& request);

/// A use case not yet planned, for who places it himself.
struct RequestedUseCase {
  std::unique_ptr<Catalogue> catalogue;
  UseCase use_case;
};
Result<RequestedUseCase> read_requested(const UseCaseRequest& request);
/// By NAME or FILE, with the figures of a costs file over its own. `said`: where it is named.
Result<Soc> read_soc_said(const std::string& soc, const Origin& said,
                          const std::optional<std::string>& costs = {});

/// What is wrong with the rig: a bad file, or none although frames from outside need one. Where a plan was
/// made this is left to the links and to whoever wants to know.
Faults rig_faults(const UseCase& use_case);

/// The text of a plain setting such as "input"; "" where it is not given.
std::string setting_text(const UseCase& use_case, const std::string& name);

}  // namespace svchain::program
