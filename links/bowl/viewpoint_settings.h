#pragma once
// From where a 3D view is shown: by a preset's name, on the built-in orbit, along a path from a file, or from
// a place of one's own; and how that changes while running, over a second, so that nothing jumps. The link's
// core calls it.

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "algorithms/bowl/viewpoint_path.h"
#include "framework/link/link.h"

namespace svchain {

std::vector<ParameterDescription> viewpoint_parameters();

class ViewpointMotion {
 public:
  /// What is wrong becomes a fault of the configuration.
  void configure(Configuration& configuration, const geometry::Vehicle& vehicle,
                 const bowl::BowlSurface& surface);

  /// At a time since the first frame.
  bowl::Viewpoint at(double time_s);

  /// The command "viewpoint": {"viewpoint": "left"} by name or file, or {"eye_m": [..], "target_m": [..],
  /// "up": [..], "field_of_view_deg": ..}. Throws std::invalid_argument for one that is no good.
  nlohmann::json go_to(const nlohmann::json& arguments);

  /// The bowl has changed: presets and paths follow it, and no eye stays in a wall.
  void follow(const bowl::BowlSurface& surface);

 private:
  struct Source {
    bowl::Viewpoint still;
    std::optional<bowl::ViewpointPath> path;
    bowl::Viewpoint at(double time_s) const { return path ? path->at(time_s) : still; }
  };
  Result<Source> named(const std::string& name) const;
  Result<Source> placed(const Parameters& given) const;
  Result<Source> wanted(const Parameters& given) const;
  void start_change();

  geometry::Vehicle vehicle_;
  bowl::BowlSurface surface_;
  Parameters given_;  // what is wanted, as it was said
  Source to_;
  std::optional<bowl::Viewpoint> from_;  // where a change began
  double from_s_ = 0, now_s_ = 0;
  bowl::Viewpoint now_;
};

}  // namespace svchain
