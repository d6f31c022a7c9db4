#include "usecases/svchain_accuracy/reasons.h"

namespace svchain::accuracy {

std::string reasons_of(const calibration::Calibration& made) {
  std::string reasons;
  const auto add = [&](const std::string& reason) { reasons += (reasons.empty() ? "" : "; ") + reason; };
  for (const auto& reason : made.reasons) add(reason);
  for (size_t c = 0; c < made.cameras.size(); ++c) {
    for (const auto& reason : made.cameras[c].reasons) add(made.rig.cameras[c].name + ": " + reason);
  }
  return reasons;
}

}  // namespace svchain::accuracy
