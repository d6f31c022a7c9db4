#include "usecases/svchain/comparison.h"

#include <algorithm>
#include <cstdio>

#include "algorithms/photometric/block_means.h"
#include "algorithms/registration/alignment.h"
#include "algorithms/synthesis/view_places.h"
#include "links/geometric_alignment/features_alignment.h"

namespace svchain::program {

namespace {

using Json = nlohmann::json;

constexpr size_t kFewestFeatures = 5;  // for a median that tells something

size_t next_clockwise(size_t camera) {
  return (camera + 1) % 4;
}

std::string overlap_name(size_t a) {
  return geometry::kCameraNames[a] + "-" + geometry::kCameraNames[next_clockwise(a)];
}

/// The lower one of two.
double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::optional<double> mean_over(const CompositeFigures& figures,
                                std::optional<double> OverlapFigures::*figure) {
  double sum = 0;
  int count = 0;
  for (const OverlapFigures& overlap : figures.overlaps) {
    if (!(overlap.*figure)) continue;
    sum += *(overlap.*figure);
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// A block counts as much as it has pixels.
void add_differences(const LastComposite& composite, const synthesis::GeometricLut& lut,
                     CompositeFigures& figures) {
  std::array<double, 4> sums = {}, pixels = {};
  for (const auto& block : photometric::block_means(lut, composite.frames, composite.tone_mapping)) {
    const auto a = static_cast<size_t>(block.camera_a);
    ++figures.overlaps[a].blocks;
    sums[a] += block.pixels * block.difference();
    pixels[a] += block.pixels;
  }
  for (size_t a = 0; a < 4; ++a)
    if (pixels[a] > 0) figures.overlaps[a].difference_levels = sums[a] / pixels[a];
}

void add_misalignment(const synthesis::GeometricLut& lut, const SharedFeatures& features,
                      CompositeFigures& figures) {
  std::vector<synthesis::ViewPlaces> places;
  places.reserve(4);
  for (int camera = 0; camera < 4; ++camera) places.emplace_back(lut, camera);
  for (size_t a = 0; a < 4; ++a) {
    std::vector<double> apart_px;
    for (const SharedFeature& feature : features[a]) {
      const auto by_a = places[a].find(feature.pixel_a);
      const auto by_b = places[next_clockwise(a)].find(feature.pixel_b);
      if (by_a && by_b) apart_px.push_back((*by_a - *by_b).norm());
    }
    OverlapFigures& overlap = figures.overlaps[a];
    overlap.features = apart_px.size();
    if (overlap.features >= kFewestFeatures) overlap.misalignment_px = median(apart_px);
  }
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json in_cm(const std::optional<double>& px, double metres_per_px) {
  return px ? Json(*px * metres_per_px * 100) : Json();
}

std::string cell(const char* format, const std::optional<double>& value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value.value_or(0));
  const size_t width = std::string(text).size();
  return value ? text : std::string(width - 1, ' ') + "-";
}

}  // namespace

SharedFeatures shared_features(const geometry::Rig& rig, const std::array<cv::Mat, 4>& frames) {
  SharedFeatures features;
  const auto found = registration::align_by_any_matches(alignment_task(rig, frames));
  if (!found) return features;
  for (const auto& overlap : found->overlaps) {
    if (overlap.inliers() < registration::kFewestMatches) continue;
    for (const auto& match : overlap.matches)
      if (match.inlier) features[overlap.a].push_back({match.pixel_a, match.pixel_b});
  }
  return features;
}

std::optional<double> CompositeFigures::difference_levels() const {
  return mean_over(*this, &OverlapFigures::difference_levels);
}

std::optional<double> CompositeFigures::misalignment_px() const {
  return mean_over(*this, &OverlapFigures::misalignment_px);
}

CompositeFigures figures_of(const LastComposite& composite, const SharedFeatures& features) {
  const synthesis::GeometricLut lut(composite.lut);
  CompositeFigures figures;
  figures.metres_per_px = lut.header().metres_per_px;
  add_differences(composite, lut, figures);
  add_misalignment(lut, features, figures);
  return figures;
}

Json figures_json(const CompositeFigures& figures) {
  const auto in_units = [&](const auto& difference_levels, const auto& misalignment_px) {
    return Json{{"difference_levels", or_null(difference_levels)},
                {"misalignment_cm", in_cm(misalignment_px, figures.metres_per_px)},
                {"misalignment_px", or_null(misalignment_px)}};
  };
  Json json = {{"mean", in_units(figures.difference_levels(), figures.misalignment_px())}};
  for (size_t a = 0; a < 4; ++a) {
    const OverlapFigures& overlap = figures.overlaps[a];
    Json& entry = json["overlaps"][overlap_name(a)];
    entry = in_units(overlap.difference_levels, overlap.misalignment_px);
    entry["blocks"] = overlap.blocks;
    entry["features"] = overlap.features;
  }
  return json;
}

std::string figures_table(const std::vector<NamedFigures>& compared) {
  std::string table;
  const auto add = [&](const char* title, auto of_overlap, auto of_all) {
    table += title;
    for (size_t a = 0; a < 4; ++a) {
      char name[24];
      std::snprintf(name, sizeof name, "%13s", overlap_name(a).c_str());
      table += name;
    }
    table += "     mean\n";
    for (const auto& [name, figures] : compared) {
      char line[16];
      std::snprintf(line, sizeof line, "%-13s", name.c_str());
      table += line;
      for (const OverlapFigures& overlap : figures.overlaps) table += cell("%13.2f", of_overlap(overlap));
      table += cell("%9.2f", of_all(figures)) + "\n";
    }
  };
  add(
      "grey levels  ", [](const OverlapFigures& o) { return o.difference_levels; },
      [](const CompositeFigures& f) { return f.difference_levels(); });
  add(
      "apart, px    ", [](const OverlapFigures& o) { return o.misalignment_px; },
      [](const CompositeFigures& f) { return f.misalignment_px(); });
  return table;
}

}  // namespace svchain::program
