#include <iostream>

#include "algorithms/bowl/path_json.h"
#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/scene/scene_file.h"
#include "framework/fault/fault_script.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/file_kind.h"
#include "usecases/svchain/say_faults.h"

namespace svchain::program {

namespace {

namespace fs = std::filesystem;

const geometry::Vehicle kUsualCar{4.8, 1.9};  // of which a path file does not tell

Faults check(const fs::path& file, FileKind kind) {
  switch (kind) {
    case FileKind::kUseCase: {
      UseCaseRequest request;
      request.use_case = file.string();
      const auto planned = plan_use_case(request);
      return planned ? rig_faults(planned->plan.use_case) : planned.error();
    }
    case FileKind::kRig:
      return faults_of(geometry::read_rig(file));
    case FileKind::kSoc:
      return faults_of(read_soc(file));
    case FileKind::kScene:
      return faults_of(scene::read_scene(file));
    case FileKind::kCharts:
      return faults_of(calibration::read_charts(file));
    case FileKind::kPath:
      return faults_of(bowl::read_path(file, kUsualCar, bowl::default_surface(kUsualCar)));
    case FileKind::kCosts:
      return faults_of(read_cost_file(file));
    case FileKind::kFaults:
      return faults_of(read_fault_script(file));
  }
  return {};
}

}  // namespace

int validate(const std::vector<fs::path>& files) {
  Faults all;
  for (const fs::path& file : files) {
    const auto document = json::Document::read(file);
    const Result<FileKind> kind = document ? kind_of(*document) : tl::unexpected(document.error());
    const Faults faults = kind ? check(file, *kind) : kind.error();
    if (faults.empty()) std::cout << file.string() << ": ok (" << name_of(*kind) << ")\n";
    append(all, faults);
  }
  return all.empty() ? kDone : say(all);
}

}  // namespace svchain::program
