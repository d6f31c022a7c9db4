#pragma once
// lighting.h and contact_shadow.h for many samples at once, on vectors (Highway), and the bytes that a
// display is given. A triangle whose corners have the normals n_k and are seen from the eye at p_k is met by
// the ray r where the corners' shares are as r.c_k, c_0 = p_1 x p_2 and so on (Cramer), so that there
//
//   normal ~ -M r,  M = sum n_k c_k^T       on the viewer's side, as r.(c_0 + c_1 + c_2) changes sign with it
//   height = (eye_z + r_z / (r.q)) / top,   q = (c_0 + c_1 + c_2) / (p_0.c_0)
//
// Plain values and functions; any thread. Nothing allocates or throws.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "algorithms/car/contact_shadow.h"
#include "algorithms/car/lighting.h"

namespace svchain::car {

/// What the samples of one triangle share, for one eye.
struct Facet {
  std::array<float, 9> normal;         // -M, row by row
  std::array<float, 3> inverse_depth;  // q
  float part = 0;                      // of the model; in floats, as all the rest
  std::array<float, 3> unused = {};    // so that a facet is a line of the cache
};

Facet facet_of(const std::array<const Vertex*, 3>& corners, const Eigen::Vector3f& eye, uint32_t part);

/// What lighting.h needs of a material.
struct Substance {
  explicit Substance(const Material& material);

  std::array<float, 3> scattering;  // base (1 - metallic) opacity
  std::array<float, 3> f0;
  float gloss, opacity;
};

/// The ray from the eye at sample (i, j) of the rectangle, in the vehicle's frame: first + i right + j down.
struct Rays {
  Eigen::Vector3f eye, first, right, down;
};

struct Scenery {
  Light light;
  Rays rays;
  float top = 1;  // the model's height
  const Facet* facets = nullptr;
  const Substance* substances = nullptr;
};

/// Arrays are read and written up to the next multiple of this.
inline constexpr size_t kMostLanes = 16;

/// Sample (columns[k], rows[k]) sees facet facets[k]. Fills rgba with what reaches the eye: linear
/// R, G, B, premultiplied, and alpha.
void light_samples(const Scenery& scenery, const int32_t* facets, const float* columns, const float* rows,
                   size_t count, float* rgba);

/// Pixels of one row of the rectangle as bytes: the surfaces over their shadow, times the opacity.
void encode_pixels(const Rays& rays, const ContactShadow& shadow, float opacity, int row, const float* rgba,
                   size_t count, uint32_t* bgra);

}  // namespace svchain::car
