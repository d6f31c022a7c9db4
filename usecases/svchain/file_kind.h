#pragma once
// What a JSON file is, told by its keys.

#include <string>

#include "algorithms/json/document.h"

namespace svchain::program {

enum class FileKind { kUseCase, kRig, kSoc, kScene, kCharts, kPath, kCosts, kFaults };

/// "use case", "rig", "SoC", "scene", "charts", "path", "costs", "faults".
const char* name_of(FileKind kind);

/// A file that is none of them is a fault that says what was looked for.
Result<FileKind> kind_of(const json::Document& document);

}  // namespace svchain::program
