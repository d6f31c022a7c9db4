#pragma once
// Why a calibration was not accepted, in one line; nothing where it was. Pure.

#include <string>

#include "algorithms/calibration/calibration.h"

namespace svchain::accuracy {

std::string reasons_of(const calibration::Calibration& made);

}  // namespace svchain::accuracy
