#pragma once
// The shipped use cases as whole chains on simulated cores, on a small simulated world; and cameras that
// misbehave.

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "framework/chain/chain.h"
#include "framework/link/catalogue.h"
#include "tests/test_data.h"

namespace svchain::testing {

class SurroundView {
 public:
  SurroundView();

  /// A shipped use case (or its text, changed) on a small world, with a view of 220 x 270 px.
  Plan plan(const std::string& use_case, const std::string& soc = "tda2x",
            const std::vector<std::string>& overrides = {}) const;
  /// The text of a shipped use case, with a "camera_fault" link between capture and sync on one camera.
  static nlohmann::json with_camera_fault(const std::string& use_case, const std::string& camera,
                                          const nlohmann::json& params);
  /// Runs a plan by hand under the virtual clock and gives the report.
  nlohmann::json run(Plan plan, uint64_t frames, std::optional<uint64_t> seed = {}) const;

  Catalogue& catalogue() { return catalogue_; }

 private:
  Catalogue catalogue_;
  TemporaryFolder folder_;
};

ChainOptions by_hand_options(uint64_t frames);

}  // namespace svchain::testing
