#include "usecases/svchain/plan_use_case.h"

#include <algorithm>

#include "algorithms/geometry/rig.h"
#include "framework/link/plugin.h"
#include "links/builtin_links.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/shipped_files.h"

namespace svchain::program {

namespace {

namespace fs = std::filesystem;

/// The value of a Result, or nothing and its faults added.
template <class T>
std::optional<T> taken(Result<T> result, Faults& faults) {
  if (result) return std::move(*result);
  append(faults, result.error());
  return std::nullopt;
}

/// Faults of a name carry what it was said with.
Result<fs::path> find_said(const Shelf& shelf, const std::string& name, const Origin& said) {
  auto found = find_file(shelf, name);
  if (!found) return tl::unexpected(Faults{said.fault(found.error().front().message)});
  return found;
}

void load_plugins(const std::vector<std::string>& libraries, Catalogue& catalogue, Faults& faults) {
  for (const std::string& library : libraries) taken(load_plugin(library, catalogue), faults);
}

void override_setting(UseCase& use_case, const std::string& name, const std::optional<std::string>& value) {
  if (value) use_case.settings.at(name).put("value", *value);
}

std::optional<UseCase> read(const UseCaseRequest& request, Catalogue& catalogue, Faults& faults) {
  const auto file = taken(find_said(kUseCases, request.use_case, {"--usecase", {}, {}}), faults);
  load_plugins(request.plugins, catalogue, faults);
  if (!file) return std::nullopt;
  const auto plugins = taken(read_plugins(*file), faults);
  if (!plugins) return std::nullopt;
  const size_t sound = faults.size();
  load_plugins(*plugins, catalogue, faults);

  std::vector<Override> overrides;
  for (const std::string& set : request.sets) overrides.push_back({set});
  auto [use_case, found] = read_as_far_as_it_goes(*file, catalogue, overrides);
  append(faults, found);
  if (!use_case || (faults.size() > sound && found.empty())) return std::nullopt;
  override_setting(*use_case, "input", request.input);
  override_setting(*use_case, "output", request.output);
  override_setting(*use_case, "rig", request.rig);
  if (!request.soc.empty()) {
    use_case->soc = request.soc;
    use_case->soc_origin = {"--soc", {}, {}};
  }
  return use_case;
}

std::optional<Soc> soc_of(const UseCase& use_case, const UseCaseRequest& request, Faults& faults) {
  if (!use_case.soc.empty())
    return taken(read_soc_said(use_case.soc, use_case.soc_origin, request.costs), faults);
  faults.push_back({use_case.file,
                    {},
                    {},
                    "which SoC? expected \"soc\" in the file, or --soc (known: " +
                        spoken_list(shipped_names(kSocs)) + ")"});
  return std::nullopt;
}

}  // namespace

std::string setting_text(const UseCase& use_case, const std::string& name) {
  const auto setting = use_case.settings.find(name);
  return setting != use_case.settings.end() && setting->second.given("value") ? setting->second.text("value")
                                                                              : "";
}

Faults rig_faults(const UseCase& use_case) {
  const std::string rig = setting_text(use_case, "rig");
  if (!rig.empty()) return faults_of(geometry::read_rig(rig));
  const std::string input = setting_text(use_case, "input");
  if (input.empty() || input.starts_with("simulated:")) return {};
  return {{"--rig",
           {},
           {},
           "missing: frames from \"" + input + "\" need a rig file that says how the cameras look"}};
}

Result<RequestedUseCase> read_requested(const UseCaseRequest& request) {
  auto catalogue = std::make_unique<Catalogue>();
  add_builtin_links(*catalogue);
  Faults faults;
  auto use_case = read(request, *catalogue, faults);
  if (!faults.empty() || !use_case) return tl::unexpected(std::move(faults));
  return RequestedUseCase{std::move(catalogue), std::move(*use_case)};
}

Result<Soc> read_soc_said(const std::string& name, const Origin& said,
                          const std::optional<std::string>& costs_file) {
  Faults faults;
  const auto file = taken(find_said(kSocs, name, said), faults);
  auto soc = file ? taken(read_soc(*file), faults) : std::nullopt;
  const auto costs = costs_file ? taken(read_cost_file(*costs_file), faults) : std::nullopt;
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  if (costs) overlay(soc->costs, *costs);
  return std::move(*soc);
}

Result<PlannedUseCase> plan_use_case(const UseCaseRequest& request) {
  PlannedUseCase planned{std::make_unique<Catalogue>(), {}};
  add_builtin_links(*planned.catalogue);
  Faults faults;
  auto use_case = read(request, *planned.catalogue, faults);
  if (!use_case) {  // what the command line names can be checked all the same
    if (!request.soc.empty())
      append(faults, faults_of(read_soc_said(request.soc, {"--soc", {}, {}}, request.costs)));
    if (request.rig) append(faults, faults_of(geometry::read_rig(*request.rig)));
    return tl::unexpected(std::move(faults));
  }
  const Faults of_rig = rig_faults(*use_case);
  const bool faulty = !faults.empty();
  if (auto soc = soc_of(*use_case, request, faults)) {
    if (faulty) {
      append(faults, plan_faults(std::move(*use_case), std::move(*soc), *planned.catalogue));
    } else if (auto plan =
                   taken(make_plan(std::move(*use_case), std::move(*soc), *planned.catalogue), faults)) {
      planned.plan = std::move(*plan);
    }
  }
  if (faults.empty()) return planned;
  append(faults, of_rig);
  return tl::unexpected(std::move(faults));
}

}  // namespace svchain::program
