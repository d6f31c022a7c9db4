#pragma once
// What the stages of a frame by OpenGL ES cost, one at a time: each begins when the one before has ended for
// good, which no run waits for. One thread.

#include "usecases/svchain_bench/synthesis_scene.h"

namespace svchain::bench {

struct GlStages {
  double upload_ms = 0, draw_ms = 0, read_back_ms = 0;
};

/// Medians over frames of the car park's 3D view on its orbit, the car included. `frames` says which of a
/// set's pictures are uploaded. Throws std::runtime_error where there is no OpenGL ES 3.
GlStages gl_stages(const ParkedCar& car, const SynthesisScene& scene,
                   SynthesisScene::Pictures SynthesisScene::Set::*frames);

}  // namespace svchain::bench
