#include "usecases/svchain/file_kind.h"

#include <nlohmann/json.hpp>

namespace svchain::program {

const char* name_of(FileKind kind) {
  constexpr const char* kNames[] = {"use case", "rig", "SoC", "scene", "charts", "path", "costs", "faults"};
  return kNames[static_cast<int>(kind)];
}

Result<FileKind> kind_of(const json::Document& document) {
  const nlohmann::json& root = document.root();
  if (root.contains("links") || root.contains("edges")) return FileKind::kUseCase;
  if (root.contains("cores")) return FileKind::kSoc;
  if (root.contains("rig") || root.contains("ground")) return FileKind::kScene;
  if (root.contains("cameras") || root.contains("vehicle")) return FileKind::kRig;
  if (root.contains("charts")) return FileKind::kCharts;  // last: scenes have some too
  if (root.contains("key_frames")) return FileKind::kPath;
  if (root.contains("costs")) return FileKind::kCosts;  // SoCs have some too
  if (root.contains("faults") || root.contains("random")) return FileKind::kFaults;
  return fail(
      document.file(),
      "what is it? expected a use case (with \"links\"), a rig (\"cameras\"), a SoC (\"cores\"), "
      "a scene (\"ground\"), charts (\"charts\"), a path (\"key_frames\"), costs (\"costs\") or faults "
      "(\"faults\" or \"random\")");
}

}  // namespace svchain::program
