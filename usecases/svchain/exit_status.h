#pragma once
// What the program's exit status says.

namespace svchain::program {

constexpr int kDone = 0;
constexpr int kFailed = 1;         // the run failed
constexpr int kBadUsage = 2;       // a bad option or a bad file
constexpr int kInterrupted = 130;  // by a signal, before there was a result

}  // namespace svchain::program
