#pragma once
// Where, with what and when something was measured, as a page names it. Any thread but for today().

#include <string>

namespace svchain::page {

/// The processor's name as the system gives it, "unknown processor" where it gives none.
std::string processor();
/// Name and version of what this was compiled with.
std::string compiler();
std::string opencv_version();
/// "2024-03-31", of Greenwich.
std::string today();

}  // namespace svchain::page
