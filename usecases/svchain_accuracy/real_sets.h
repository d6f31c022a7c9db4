#pragma once
// The real recordings as calibrations start from them. Reads files; otherwise pure.

#include <filesystem>

#include "algorithms/calibration/calibration.h"
#include "algorithms/json/fault.h"

namespace svchain::accuracy {

/// The carpet around a car, from its author's calibration.
Result<calibration::CalibrationInput> read_carpet(const std::filesystem::path& data);
/// The boards around a car in a garage, nobody having measured where, from its author's calibration.
Result<calibration::CalibrationInput> read_garage(const std::filesystem::path& data);

}  // namespace svchain::accuracy
