#pragma once
// Pictures for measuring photometric alignment: of simulated cars whose cameras' responses are known, and the
// real recordings. Pure functions, but for the files they read.

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/view.h"
#include "algorithms/scene/scene.h"

namespace svchain::accuracy {

struct PhotometricTruth {
  std::array<scene::Response, 4> responses;
  cv::Mat ideal;  // what one perfect camera above sees, in the set's view
};

struct PhotometricSet {
  std::string name;
  geometry::Rig rig;
  geometry::View view;
  std::vector<cv::Mat> frames;  // BGR
  std::optional<PhotometricTruth> truth;
};

/// How far apart simulated cameras are: gains per camera and channel, gammas and falloffs per camera.
struct ResponseRange {
  std::string name;
  std::array<double, 2> gain, gamma, falloff_1, falloff_2;
};
extern const ResponseRange kLikeCameras;    // gains of 0.85 to 1.2 and nothing else
extern const ResponseRange kUnlikeCameras;  // gains of 0.7 to 1.4, gammas of 0.9 to 1.15, vignetting

/// The shipped car park with responses drawn from the seed, noise of 2 grey levels.
scene::Scene photometric_scene(const ResponseRange& range, uint64_t seed);
PhotometricSet simulated_photometric_set(const ResponseRange& range, uint64_t seed);

/// The composite of the shipped use cases for this vehicle.
geometry::View photometric_view(const geometry::Vehicle& vehicle);

}  // namespace svchain::accuracy
