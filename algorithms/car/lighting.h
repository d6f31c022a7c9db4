#pragma once
// How the car is lit: the definition that the CPU's rasteriser calls and the GL shader repeats. Linear R, G,
// B; vectors are unit and in the vehicle's frame; n the normal on the viewer's side, v towards the eye.
//
//   sky(d)     = mix(mix(haze, ground, min(1, 5 |d_z|)), mix(horizon, zenith, 1 - (1 - |d_z|)^2),
//                    smoothstep(-0.15, 0.1, d_z))
//   ambient(n) = mix(ground, (zenith + horizon) / 2, (1 + n_z) / 2)
//   occlusion  = mix(0.35, 1, smoothstep(0, 0.4, height)),  height = z / the model's height
//   f0         = mix(0.04, base, metallic)
//   fresnel    = f0 + (1 - f0) (1 - n.v)^5                                 (Schlick 1994)
//   scattered  = base (1 - metallic) (occlusion ambient(n) + sun max(n.s, 0))
//   mirrored   = fresnel mix(0.4, 1, gloss) occlusion (mix(ambient(r), sky(r), gloss) + spot),  r = reflected
//   v spot       = sun gloss 4 t / (k - k t + t), t = max(r.s, 0), k = 4 + 400 gloss^2   (Schlick's rational
//   power) colour     = opacity scattered + mirrored,  alpha = opacity + (1 - opacity) mean(fresnel):
//   premultiplied display(c) = (c (1 + c / 2) / (1 + c))^(1 / 2.2): extended Reinhard, white at 2^(1/2), then
//   gamma

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "algorithms/car/car_model.h"

namespace svchain::car {

struct Light {
  Eigen::Vector3f to_sun;   // unit
  Eigen::Vector3f sun;      // what a white surface facing it scatters
  Eigen::Vector3f zenith;   // the sky
  Eigen::Vector3f horizon;  // its lower edge
  Eigen::Vector3f haze;     // the ground's far edge
  Eigen::Vector3f ground;
};

/// A bright day, the sun over the car's front left.
inline Light bright_day() {
  return {Eigen::Vector3f(0.42f, 0.48f, 0.77f).normalized(),
          {1.5f, 1.42f, 1.3f},
          {0.26f, 0.38f, 0.62f},
          {1.25f, 1.3f, 1.35f},
          {0.17f, 0.17f, 0.17f},
          {0.10f, 0.10f, 0.095f}};
}

struct Lit {
  Eigen::Vector3f colour;  // premultiplied
  float alpha;
};

inline Eigen::Vector3f mix(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float t) {
  return a + (b - a) * t;
}

inline float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

inline Eigen::Vector3f sky(const Light& light, const Eigen::Vector3f& direction) {
  const float off = std::abs(direction.z());
  const Eigen::Vector3f below = mix(light.haze, light.ground, std::min(1.0f, 5 * off));
  const Eigen::Vector3f above = mix(light.horizon, light.zenith, 1 - (1 - off) * (1 - off));
  return mix(below, above, smoothstep(-0.15f, 0.1f, direction.z()));
}

inline Eigen::Vector3f ambient(const Light& light, const Eigen::Vector3f& normal) {
  return mix(light.ground, (light.zenith + light.horizon) * 0.5f, 0.5f + 0.5f * normal.z());
}

/// What reaches the eye from a surface at `height` (0 on the ground, 1 at the car's top).
inline Lit lit(const Light& light, const Material& material, const Eigen::Vector3f& normal,
               const Eigen::Vector3f& to_eye, float height) {
  const float towards = std::clamp(normal.dot(to_eye), 0.0f, 1.0f);
  const float occlusion = 0.35f + 0.65f * smoothstep(0.0f, 0.4f, height);
  const Eigen::Vector3f f0 = mix(Eigen::Vector3f::Constant(0.04f), material.base_colour, material.metallic);
  const float grazing = (1 - towards) * (1 - towards) * (1 - towards) * (1 - towards) * (1 - towards);
  const Eigen::Vector3f fresnel = mix(f0, Eigen::Vector3f::Ones(), grazing);

  const Eigen::Vector3f received =
      ambient(light, normal) * occlusion + light.sun * std::max(0.0f, normal.dot(light.to_sun));
  const Eigen::Vector3f scattered = material.base_colour.cwiseProduct(received) * (1 - material.metallic);

  const Eigen::Vector3f reflected = 2 * normal.dot(to_eye) * normal - to_eye;
  const float gloss = material.gloss, t = std::max(0.0f, reflected.dot(light.to_sun));
  const float k = 4 + 400 * gloss * gloss;
  const Eigen::Vector3f mirrored_light = mix(ambient(light, reflected), sky(light, reflected), gloss) +
                                         light.sun * (gloss * 4 * t / (k - k * t + t));
  const Eigen::Vector3f mirrored = fresnel.cwiseProduct(mirrored_light) * ((0.4f + 0.6f * gloss) * occlusion);
  return {scattered * material.opacity + mirrored,
          material.opacity + (1 - material.opacity) * fresnel.mean()};
}

/// A linear component as a display shows it, 0..1.
inline float display(float linear) {
  const float shown = linear * (1 + linear / 2) / (1 + linear);
  return std::pow(std::clamp(shown, 0.0f, 1.0f), 1 / 2.2f);
}

}  // namespace svchain::car
