#pragma once
// A calibration for people: what came of it, camera by camera and overlap by overlap, and why it was rejected
// if it was.

#include <string>

#include "algorithms/calibration/calibration.h"
#include "algorithms/json/fault.h"

namespace svchain::program {

std::string calibration_table(const calibration::Calibration& calibration);

/// The reasons of every camera, by its name, and of the whole.
Faults reasons_of(const calibration::Calibration& calibration);

}  // namespace svchain::program
