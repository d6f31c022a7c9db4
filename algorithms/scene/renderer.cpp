#include "algorithms/scene/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "algorithms/scene/hash.h"
#include "algorithms/scene/motion.h"

namespace svchain::scene {

namespace {

constexpr int kMost = Sensor::kMostPixels;

/// From a span's coordinates to a texture's, in texels.
struct Mapping {
  const Texture* texture = nullptr;
  float c = 1, s = 0, tx = 0, ty = 0;
  float foot_u = 0, foot_v = 0;
};

Mapping to_ground(const GroundLevel& level, const Pose2& pose, const SightLines& lines) {
  const Eigen::Vector2d foot = pose * Eigen::Vector2d(lines.foot_x_m, lines.foot_y_m);
  return {&level.texture,
          static_cast<float>(std::cos(pose.yaw_rad)),
          static_cast<float>(std::sin(pose.yaw_rad)),
          static_cast<float>(level.texel_at(pose.x_m)),
          static_cast<float>(level.texel_at(pose.y_m)),
          static_cast<float>(level.texel_at(foot.x())),
          static_cast<float>(level.texel_at(foot.y()))};
}

Mapping to_panorama(const Panorama& panorama, const Pose2& pose) {
  const double turned = pose.yaw_rad / panorama.radians_per_texel;
  return {&panorama.texture, 1, 0, static_cast<float>(turned), 0, 0, 0};
}

/// Two texels side by side, or what has become of them: B, G, R, nothing, twice. Of gcc and clang, for any
/// processor.
using Bytes = uint8_t __attribute__((vector_size(8)));
using Words = uint16_t __attribute__((vector_size(16)));
using Quads = uint32_t __attribute__((vector_size(16)));
using Halves = uint64_t __attribute__((vector_size(16)));

/// Where bilinear samples lie: their first texels, and the weights (256ths, doubled into both halves of a
/// word) of the texels there, to the right, below, and below to the right.
struct Samples {
  int first[kMost];
  uint32_t w00[kMost], w01[kMost], w10[kMost], w11[kMost];
};

constexpr uint32_t kDoubled = 0x00010001;

/// Everything in floats, which hold whole numbers up to 2^24 exactly: any processor has vectors of them.
void locate(const float* u, const float* v, int count, float width, Samples& samples) {
  for (int i = 0; i < count; ++i) {
    const auto column = static_cast<float>(static_cast<int>(u[i]));
    const auto row = static_cast<float>(static_cast<int>(v[i]));
    samples.first[i] = static_cast<int>(row * width + column);
    const int fx = static_cast<int>((u[i] - column) * 256);
    const int fy = static_cast<int>((v[i] - row) * 256);
    const int w11 = static_cast<int>(static_cast<float>(fx) * static_cast<float>(fy) * (1 / 256.0f));
    samples.w00[i] = static_cast<uint32_t>(256 - fx - fy + w11) * kDoubled;
    samples.w01[i] = static_cast<uint32_t>(fx - w11) * kDoubled;
    samples.w10[i] = static_cast<uint32_t>(fy - w11) * kDoubled;
    samples.w11[i] = static_cast<uint32_t>(w11) * kDoubled;
  }
}

Words two_texels(const uint32_t* at) {
  Bytes bytes;
  std::memcpy(&bytes, at, sizeof bytes);
  return __builtin_convertvector(bytes, Words);
}

Words spread(uint32_t left, uint32_t right) {
  return reinterpret_cast<Words>(Quads{left, left, right, right});
}

/// Adds a 2^-shift part of each sample, as 8.8 fixed point, to `light`: four words a pixel.
void add_samples(const Texture& texture, const Samples& samples, int count, int shift, uint64_t* light) {
  const uint32_t* texels = texture.texels.data();
  const auto width = static_cast<ptrdiff_t>(texture.width);
  const uint64_t keep = (0xffffu >> shift) * uint64_t{0x0001000100010001};
  for (int i = 0; i < count; ++i) {
    __builtin_prefetch(texels + samples.first[i]);
    __builtin_prefetch(texels + samples.first[i] + width);
  }
  for (int i = 0; i < count; ++i) {
    const uint32_t* at = texels + samples.first[i];
    const Words upper = two_texels(at) * spread(samples.w00[i], samples.w01[i]);
    const Words lower = two_texels(at + width) * spread(samples.w10[i], samples.w11[i]);
    const Halves sum = reinterpret_cast<Halves>(upper + lower);
    light[i] += (sum[0] + sum[1]) >> shift & keep;
  }
}

/// Wider vectors where the processor has them; the arithmetic, and so every pixel, stays the same. Not under
/// the thread sanitizer: the choice is made while the program is loaded, before the sanitizer is there.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define SVCHAIN_WIDE __attribute__((target_clones("arch=x86-64-v3", "default"), flatten))
#else
#define SVCHAIN_WIDE
#endif

/// The light that `count` pixels from `pixel` on receive, as Sensor takes it. Every sample is within the
/// texture by construction: a span's level reaches wherever the vehicle may go.
SVCHAIN_WIDE void gather(const SightLines& lines, const Span& span, const Mapping& m, size_t pixel, int count,
                         uint64_t* light) {
  float centre_u[kMost], centre_v[kMost], u[kMost], v[kMost];
  Samples samples;
  const float* x = &lines.x[pixel];
  const float* y = &lines.y[pixel];
  const float* stretch = &lines.stretch[pixel];
  for (int i = 0; i < count; ++i) {
    centre_u[i] = m.c * x[i] - m.s * y[i] + m.tx;
    centre_v[i] = m.s * x[i] + m.c * y[i] + m.ty;
  }
  std::fill_n(light, count, 0);
  const auto width = static_cast<float>(m.texture->width);
  const int taps = 1 << span.taps_log2;
  for (int tap = 0; tap < taps; ++tap) {
    const float offset = static_cast<float>(tap) - 0.5f * static_cast<float>(taps - 1);
    for (int i = 0; i < count; ++i) {
      u[i] = centre_u[i] + offset * stretch[i] * (centre_u[i] - m.foot_u);
      v[i] = centre_v[i] + offset * stretch[i] * (centre_v[i] - m.foot_v);
    }
    locate(u, v, count, width, samples);
    add_samples(*m.texture, samples, count, span.taps_log2, light);
  }
}

}  // namespace

Renderer::Renderer(std::shared_ptr<const World> world) : world_(std::move(world)) {
  const Scene& scene = world_->scene();
  for (size_t camera = 0; camera < scene.rig.cameras.size(); ++camera) {
    lines_.push_back(trace_sight_lines(*world_, camera));
    solids_.emplace_back(scene, camera);
    sensors_.emplace_back(scene.responses[camera], hash(scene.seed, camera));
  }
}

void Renderer::render(size_t camera, double time_s, uint64_t frame, cv::Mat& bgr) const {
  const SightLines& lines = lines_[camera];
  const Sensor& sensor = sensors_[camera];
  bgr.create(lines.height, lines.width, CV_8UC3);

  const Pose2 pose = world_from_vehicle(world_->scene().path, time_s);
  std::array<Mapping, 256> mappings;  // by a span's target
  for (size_t i = 0; i < world_->ground().size(); ++i)
    mappings[i] = to_ground(world_->ground()[i], pose, lines);
  mappings[Span::kPanorama] = to_panorama(world_->panorama(), pose);

  uint64_t light[kMost];
  for (int row = 0; row < lines.height; ++row) {
    uint8_t* out = bgr.ptr<uint8_t>(row);
    const size_t row_start = static_cast<size_t>(row) * static_cast<size_t>(lines.width);
    for (size_t s = lines.first_span[static_cast<size_t>(row)];
         s < lines.first_span[static_cast<size_t>(row) + 1]; ++s) {
      const Span& span = lines.spans[s];
      if (span.target == Span::kNothing) {
        std::memset(out + 3 * span.first, 0, 3u * span.count);
        continue;
      }
      for (int first = span.first; first < span.first + span.count; first += kMost) {
        const int count = std::min(kMost, span.first + span.count - first);
        const size_t pixel = row_start + static_cast<size_t>(first);
        gather(lines, span, mappings[span.target], pixel, count, light);
        solids_[camera].cover(pose, pixel, static_cast<size_t>(count), light);
        sensor.develop(light, &lines.falloff[pixel], count, hash(frame, pixel), out + 3 * first);
      }
    }
  }
}

}  // namespace svchain::scene
