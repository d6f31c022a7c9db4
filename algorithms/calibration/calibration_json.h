#pragma once
// What a calibration says of itself, as JSON: the report, and the part of it that goes into the rig
// (contracts: "Rig"). `date` is ISO 8601, UTC. Pure.

#include <string>
#include <vector>

#include "algorithms/calibration/accuracy.h"
#include "algorithms/calibration/calibration.h"

namespace svchain::calibration {

/// "none", "even", "odd": the values of HoldOut in their order.
const std::vector<std::string>& hold_out_names();
/// "fitted", "held_out", "rejected", "not_found": the values of CornerState in their order.
const std::vector<std::string>& corner_state_names();

/// For geometry::Rig::calibration.
std::string rig_part(const Calibration& calibration, const std::string& date);

/// The text of a report (schema: configs/schemas/calibration.schema.json). Its "corners" are read by
/// clicked_corners.h again, its "charts" are a charts file's. Numbers that are not known are null.
std::string report_text(const CalibrationInput& input, const AcceptanceLimits& limits,
                        const Calibration& calibration, const std::string& date);

/// The keys at the top of a report.
const std::vector<std::string>& report_keys();

}  // namespace svchain::calibration
