#pragma once
// Where the time of an alignment goes, stage by stage. Plain value, one thread.

#include <chrono>
#include <string>
#include <vector>

namespace svchain::registration {

struct StageTime {
  std::string name;
  double ms = 0;
};

class StageClock {
 public:
  /// The time since the last call, or since the beginning, was spent on this stage.
  void spent_on(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    for (auto& time : times_) {
      if (time.name != stage) continue;
      time.ms += ms;
      return;
    }
    times_.push_back({stage, ms});
  }

  /// In the order in which the stages were first met.
  const std::vector<StageTime>& times() const { return times_; }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<StageTime> times_;
};

}  // namespace svchain::registration
