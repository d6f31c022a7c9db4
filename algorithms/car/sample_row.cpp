#include "algorithms/car/sample_row.h"

#include <algorithm>

namespace svchain::car {
namespace {

constexpr int kSamples = kSamplesPerSide * kSamplesPerSide;
constexpr float kAlikeCosine = 0.94f;  // planes turned by less share their light within a pixel

bool alike(uint32_t a, uint32_t b, std::span<const Plane> planes) {
  if (a == b) return true;
  if (a == kNoTriangle || b == kNoTriangle) return false;
  return planes[a].part == planes[b].part && planes[a].normal.dot(planes[b].normal) > kAlikeCosine;
}

}  // namespace

void SampleRow::reserve(int columns) {
  const size_t pixels = columns + kMostLanes, most = 2 * kSamples * pixels;
  if (means_.size() >= pixels) return;
  means_.resize(pixels);
  bytes_.resize(pixels);
  groups_.resize(kSamples * pixels);
  facets_.resize(most);
  columns_.resize(most);
  rows_.resize(most);
  colours_.resize(most);
}

void SampleRow::add(const Sample& sample, int column, int row, int k, int count) {
  const auto lit = [&](uint32_t triangle) {
    if (triangle == kNoTriangle) return kNothing;
    facets_[lit_count_] = static_cast<int32_t>(triangle);
    columns_[lit_count_] = static_cast<float>(kSamplesPerSide * column + k % kSamplesPerSide);
    rows_[lit_count_] = static_cast<float>(kSamplesPerSide * row + k / kSamplesPerSide);
    return static_cast<int32_t>(lit_count_++);
  };
  Group& group = groups_[group_count_++];
  group.column = column;
  group.share = static_cast<float>(count) / kSamples;
  group.opaque = lit(sample.opaque);
  group.translucent = lit(sample.translucent);
}

/// Where an edge crosses the pixel.
void SampleRow::split(std::array<Sample, 4>& samples, int column, int row, std::span<const Plane> planes) {
  for (int k = 0; k < kSamples; ++k) {
    const Sample first = samples[k];
    if (first.empty()) continue;
    int count = 0;
    for (int m = k; m < kSamples; ++m)
      if (alike(samples[m].opaque, first.opaque, planes) &&
          alike(samples[m].translucent, first.translucent, planes)) {
        samples[m] = {};
        ++count;
      }
    add(first, column, row, k, count);
  }
}

void SampleRow::gather(const SampleBand& samples, int first, int row, int columns,
                       std::span<const Plane> planes) {
  lit_count_ = group_count_ = 0;
  for (int column = 0; column < columns; ++column) {
    const int i = kSamplesPerSide * column;
    std::array<Sample, 4> seen = {samples.sample(i, first), samples.sample(i + 1, first),
                                  samples.sample(i, first + 1), samples.sample(i + 1, first + 1)};
    if (seen[0] != seen[1] || seen[0] != seen[2] || seen[0] != seen[3])
      split(seen, column, row, planes);
    else if (!seen[0].empty())
      add(seen[0], column, row, 0, kSamples);
  }
}

const float* SampleRow::mean_light(const SampleBand& samples, int first, int row, int columns,
                                   const Scenery& scenery, std::span<const Plane> planes) {
  reserve(columns);
  gather(samples, first, row, columns, planes);
  for (size_t k = lit_count_; k % kMostLanes != 0; ++k) {
    facets_[k] = 0;
    columns_[k] = rows_[k] = 0;
  }
  light_samples(scenery, facets_.data(), columns_.data(), rows_.data(), lit_count_, colours_.data()->data());

  std::fill_n(means_.begin(), columns, Colour::Zero());
  for (size_t k = 0; k < group_count_; ++k) {
    const Group& group = groups_[k];
    Colour seen = Colour::Zero();
    if (group.opaque != kNothing) seen = colours_[group.opaque];
    if (group.translucent != kNothing) {
      const Colour& pane = colours_[group.translucent];
      seen = pane + (1 - pane[3]) * seen;
    }
    means_[group.column] += group.share * seen;
  }
  return means_.data()->data();
}

}  // namespace svchain::car
