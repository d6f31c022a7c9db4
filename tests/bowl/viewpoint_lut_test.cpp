#include "algorithms/bowl/viewpoint_lut.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/bowl/viewpoint_presets.h"
#include "algorithms/synthesis/camera_shares.h"
#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/lut_pixels.h"
#include "algorithms/synthesis/synthesize.h"
#include "tests/catch.h"
#include "tests/synthesis/four_cameras.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;
using synthesis::LutPixel;
using synthesis::PointSources;
using synthesis::RegionKind;

namespace {

const Eigen::Vector2i kImage(640, 360);
const Eigen::Vector2i kPicture(330, 405);  // its last blocks and squares are not whole

struct Scene {
  geometry::Rig rig = four_cameras(kImage);
  BowlSurface surface = default_surface(rig.vehicle);
  std::vector<std::byte> memory = std::vector<std::byte>(ViewpointLut::capacity(kPicture));

  synthesis::GeometricLut lut_of(const Viewpoint& viewpoint, const synthesis::BlendShape& shape = {}) {
    ViewpointLut lut(rig, surface, shape);
    const size_t bytes = lut.build(viewpoint, kPicture, memory);
    return synthesis::GeometricLut(std::span(memory).first(bytes));
  }
};

Eigen::Vector2d place_in(const synthesis::LutSource& box, uint32_t entry) {
  return Eigen::Vector2d(box.x + synthesis::entry_x(entry) / 32.0, box.y + synthesis::entry_y(entry) / 32.0);
}

/// What pixels of a LUT differ from what is found for each of them alone.
struct Differences {
  int pixels = 0, other_cameras = 0;
  double worst_px = 0, sum_px = 0;
  int worst_weight = 0, places = 0;
};

void compare(const LutPixel& pixel, const synthesis::LutBlock& block, const PointSources& exact,
             Differences& found) {
  ++found.pixels;
  const int count = pixel.region->tap_count();
  const auto camera = [&](int i) {
    return block.sources[i == 0 ? pixel.region->first : pixel.region->second].camera;
  };
  // A camera with all but no share, left out or not, makes no difference.
  const auto slight = [](int weight) { return weight <= 4 || weight >= 251; };
  if (count != exact.count && (count == 2 ? slight(pixel.weight) : slight(exact.first_weight)) && count > 0 &&
      exact.count > 0)
    return;
  bool same = count == exact.count;
  for (int i = 0; same && i < count; ++i) same = camera(i) == exact.camera[i];
  if (!same) {
    ++found.other_cameras;
    return;
  }
  for (int i = 0; i < count; ++i) {
    const auto& box = block.sources[i == 0 ? pixel.region->first : pixel.region->second];
    const double off = (place_in(box, i == 0 ? pixel.first : pixel.second) - exact.image_px[i]).norm();
    found.worst_px = std::max(found.worst_px, off);
    found.sum_px += off;
    ++found.places;
  }
  if (count == 2)
    found.worst_weight = std::max(found.worst_weight, std::abs(pixel.weight - exact.first_weight));
}

Differences differences(Scene& scene, const Viewpoint& viewpoint) {
  const synthesis::GeometricLut lut = scene.lut_of(viewpoint);
  const Perspective perspective(viewpoint, kPicture);
  const synthesis::SourceFinder finder(scene.rig, {});
  Differences found;
  for (const synthesis::LutBlock& block : lut.blocks())
    for_each_pixel(lut, block, [&](const LutPixel& pixel) {
      const auto point =
          scene.surface.intersect(perspective.eye(), perspective.ray({pixel.column, pixel.row}));
      const bool black = !point || synthesis::is_under_vehicle(scene.rig.vehicle, point->head<2>());
      compare(pixel, block, black ? PointSources{} : finder.find(*point), found);
    });
  return found;
}

std::array<cv::Mat, 4> soft_frames() {
  std::array<cv::Mat, 4> frames;
  for (size_t i = 0; i < 4; ++i) {
    cv::Mat coarse(kImage.y() / 20, kImage.x() / 20, CV_8UC3);
    cv::RNG(i + 1).fill(coarse, cv::RNG::UNIFORM, 0, 256);
    cv::resize(coarse, frames[i], {kImage.x(), kImage.y()}, 0, 0, cv::INTER_CUBIC);
  }
  return frames;
}

cv::Mat rendered(const synthesis::GeometricLut& lut, const std::array<cv::Mat, 4>& frames) {
  cv::Mat out(kPicture.y(), kPicture.x(), CV_8UC3);
  synthesize(lut, frames, synthesis::ToneMapping::identity(), out, nullptr);
  return out;
}

}  // namespace

TEST_CASE("every pixel of a viewpoint's LUT shows what a ray through it meets, from every preset") {
  Scene scene;
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    const Differences found = differences(scene, *preset(name, scene.rig.vehicle, scene.surface));
    CHECK(found.pixels == kPicture.x() * kPicture.y());
    CHECK(found.places > found.pixels / 4);
    CHECK(found.worst_px < 0.6);
    CHECK(found.sum_px / found.places < 0.06);  // rounding to 1/32 px alone takes 0.012
    CHECK(found.worst_weight <= 8);
    CHECK(found.other_cameras < found.pixels / 200);  // where a weight is all but 0 or 255
  }
}

TEST_CASE("a flat bowl from straight above shows what the view of the ground shows") {
  Scene scene;
  scene.surface.height_m = 0;
  const geometry::View view{kPicture, 0.02, {0, 0}};
  const double above_m = 6;
  Viewpoint viewpoint{{0, 0, above_m}, {0, 0, 0}, {1, 0, 0}, 0};
  viewpoint.field_of_view_deg = 2 * std::atan(kPicture.y() * view.metres_per_px / 2 / above_m) * 180 / M_PI;
  std::vector<std::byte> memory(synthesis::geometric_lut_capacity(view, 4));
  const size_t bytes = synthesis::build_geometric_lut(scene.rig, view, {}, memory);
  const auto frames = soft_frames();
  const cv::Mat ground = rendered(synthesis::GeometricLut(std::span(memory).first(bytes)), frames);
  const cv::Mat bowl = rendered(scene.lut_of(viewpoint), frames);
  double sum = 0;
  int count = 0;
  for (int y = 0; y < kPicture.y(); ++y)
    for (int x = 0; x < kPicture.x(); ++x) {
      if (synthesis::is_under_vehicle(scene.rig.vehicle, view.ground_from_pixel({x, y}))) continue;
      const auto &a = ground.at<cv::Vec3b>(y, x), &b = bowl.at<cv::Vec3b>(y, x);
      for (int c = 0; c < 3; ++c) sum += std::abs(a[c] - b[c]);
      count += 3;
    }
  CHECK(count > 100'000);
  CHECK(sum / count < 1);  // frames of hard noise, places within a tenth of a pixel
}

TEST_CASE("a viewpoint's LUT shows the same in any number of parts, made in any order") {
  Scene scene;
  const Viewpoint chase = *preset("chase", scene.rig.vehicle, scene.surface);
  const auto frames = soft_frames();
  const cv::Mat expected = rendered(scene.lut_of(chase), frames);
  ViewpointLut lut(scene.rig, scene.surface, {});
  for (const int parts : {2, 3, ViewpointLut::kMostParts}) {
    lut.begin(chase, kPicture, scene.memory);
    for (int i = parts - 1; i >= 0; --i) lut.make_nodes(i, parts);
    for (int i = parts - 1; i >= 0; --i) lut.write_blocks(i, parts);
    const synthesis::GeometricLut made(std::span(scene.memory).first(lut.finish(parts)));
    CHECK(cv::norm(expected, rendered(made, frames), cv::NORM_INF) == 0);
    uint32_t overlaps = 0;
    for (const synthesis::LutBlock& block : made.blocks()) {
      CHECK(block.first_overlap >= overlaps);
      overlaps = std::max(overlaps, block.first_overlap);
    }
    CHECK(made.header().overlap_count >= overlaps);
  }
}

TEST_CASE("with a hard seam every pixel of a viewpoint's LUT has one camera or none") {
  Scene scene;
  const auto lut = scene.lut_of(*preset("chase", scene.rig.vehicle, scene.surface), {0, {}});
  for (const synthesis::LutBlock& block : lut.blocks()) CHECK_FALSE(block.blends());
}

TEST_CASE("a viewpoint's LUT is refused memory that is too small or not aligned") {
  Scene scene;
  ViewpointLut lut(scene.rig, scene.surface, {});
  const Viewpoint top = *preset("top", scene.rig.vehicle, scene.surface);
  CHECK_THROWS_WITH(lut.begin(top, kPicture, std::span(scene.memory).first(scene.memory.size() - 1)),
                    Catch::Matchers::Contains("does not suffice"));
  CHECK_THROWS_WITH(lut.begin(top, kPicture, std::span(scene.memory).subspan(1)),
                    Catch::Matchers::Contains("not aligned"));
}
