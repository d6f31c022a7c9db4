#pragma once
// What the sections about real recordings have in common.

#include <array>

#include "algorithms/json/fault.h"
#include "usecases/svchain_accuracy/agreement.h"
#include "usecases/svchain_page/document.h"

namespace svchain::accuracy {

using page::figure;
using page::met;
using page::Section;
using page::Table;

/// A section that says which file is not there.
Section absent(const std::string& title, const Faults& faults);

/// "accepted", or "rejected" and why.
std::string verdict(const calibration::Calibration& made);

/// Whether both calibrations were accepted, and how many corners were left out of the figures.
std::string how_it_ended(const HeldOutResult& result);

/// The same corner by two neighbours, limits clockwise from front-right.
Table between_cameras(const HeldOutResult& result, const std::array<double, 4>& limits_cm);

}  // namespace svchain::accuracy
