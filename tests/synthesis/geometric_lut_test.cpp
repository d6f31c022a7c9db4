#include "algorithms/synthesis/geometric_lut.h"

#include <cstring>
#include <map>
#include <random>

#include "algorithms/synthesis/camera_shares.h"
#include "algorithms/synthesis/own_body.h"
#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;

namespace {

/// The rig with one camera's lens ending at this angle.
geometry::Rig with_narrow_camera(geometry::Rig rig, int camera, double max_angle_deg) {
  const auto& lens = dynamic_cast<const geometry::KannalaBrandt&>(*rig.cameras[camera].lens);
  rig.cameras[camera].lens = std::make_shared<geometry::KannalaBrandt>(lens.focal_px(), lens.centre_px(),
                                                                       lens.k(), max_angle_deg * M_PI / 180);
  return rig;
}

geometry::Rig shipped_rig(const std::string& name) {
  const auto rig = geometry::read_rig(project_folder() / "configs" / "rigs" / (name + ".json"));
  REQUIRE(rig);
  return *rig;
}

int largest_jump(const DecodedLut& lut, const geometry::Rig& rig, const geometry::View& view) {
  const auto near_vehicle = [&](int column,
                                int row) {  // there a pixel is a large angle, for corner and camera
    const Eigen::Vector2d ground = view.ground_from_pixel({column, row}).cwiseAbs();
    const Eigen::Vector2d corner(rig.vehicle.length_m / 2, rig.vehicle.width_m / 2);
    return (ground - corner).maxCoeff() < 25 * view.metres_per_px;
  };
  const auto shows_cameras = [](const DecodedPixel& p) { return p.tap_count() > 0; };
  int largest = 0;
  for (int row = 0; row + 1 < lut.height; ++row)
    for (int column = 0; column + 1 < lut.width; ++column) {
      const DecodedPixel& here = lut.at(column, row);
      if (!shows_cameras(here) || near_vehicle(column, row)) continue;
      for (const DecodedPixel* next : {&lut.at(column + 1, row), &lut.at(column, row + 1)})
        for (int camera = 0; camera < 4 && shows_cameras(*next); ++camera)
          largest = std::max(largest, std::abs(here.weight_of(camera) - next->weight_of(camera)));
    }
  return largest;
}

}  // namespace

TEST_CASE("every pixel is covered once, and the capacity suffices, at any size and scale") {
  const auto rig = four_cameras({640, 360});
  for (const Eigen::Vector2i& size :
       {Eigen::Vector2i(333, 217), {41, 39}, {40, 40}, {1, 1}, {80, 3}, {220, 270}})
    for (const double scale : {0.3, 1.0, 4.0}) {
      auto view = view_of(rig, size);
      view.metres_per_px *= scale;
      const OwnedLut owned(rig, view);
      const DecodedLut lut = decode(owned.lut());
      CHECK(owned.bytes().size() <= owned.capacity());
      CHECK(std::all_of(lut.pixels.begin(), lut.pixels.end(), [](auto& p) { return p.times_covered == 1; }));
      CHECK(owned.lut().header().width == size.x());
      CHECK(owned.lut().blocks().size() == block_count(size));
    }
}

TEST_CASE("the paper's view takes less than six bytes a pixel and is of all three kinds of blocks") {
  const auto rig = four_cameras();
  const OwnedLut owned(rig, view_of(rig, {880, 1080}));
  const auto footprint = owned.lut().footprint();
  CHECK(footprint.bytes == owned.bytes().size());
  CHECK(footprint.bytes_per_pixel < 6);
  CHECK(footprint.empty_blocks > 0);
  CHECK(footprint.one_camera_blocks > 0);
  CHECK(footprint.blend_blocks > 0);
  CHECK(footprint.empty_blocks + footprint.one_camera_blocks + footprint.blend_blocks == 22 * 27);
}

TEST_CASE("entries lie where the camera sees the ground, to half a step") {
  const auto rig = four_cameras();
  const auto view = view_of(rig, {443, 541});
  const DecodedLut lut = decode(OwnedLut(rig, view).lut());
  size_t compared = 0;
  double largest = 0;
  for (int row = 0; row < lut.height; ++row)
    for (int column = 0; column < lut.width; ++column)
      for (int i = 0; i < lut.at(column, row).tap_count(); ++i) {
        const DecodedTap& tap = lut.at(column, row).taps[i];
        const Eigen::Vector2d ground = view.ground_from_pixel({column, row});
        const auto seen = rig.cameras[tap.camera].see({ground.x(), ground.y(), 0});
        REQUIRE(seen);
        largest = std::max({largest, std::abs(seen->x() - tap.px()), std::abs(seen->y() - tap.py())});
        ++compared;
      }
  CHECK(compared > 200000);
  CHECK(largest <= 1.0 / 64 + 1e-9);
}

TEST_CASE("boxes hold every pixel that is sampled and not one row or column more") {
  const auto rig = four_cameras({640, 360});
  const OwnedLut owned(rig, view_of(rig, {333, 217}));
  const GeometricLut geometric_lut = owned.lut();
  const DecodedLut lut = decode(geometric_lut);
  struct Box {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
  };
  std::vector<std::array<Box, 4>> boxes(geometric_lut.blocks().size());
  for (const DecodedPixel& pixel : lut.pixels)
    for (int i = 0; i < pixel.tap_count(); ++i) {
      const DecodedTap& tap = pixel.taps[i];
      Box& box = boxes[pixel.block][tap.camera];
      box = {std::min(box.left, tap.x), std::min(box.top, tap.y), std::max(box.right, tap.x + 1),
             std::max(box.bottom, tap.y + 1)};
    }
  for (size_t index = 0; index < boxes.size(); ++index) {
    const LutBlock& block = geometric_lut.blocks()[index];
    uint32_t cameras = 0;
    for (const Box& box : boxes[index]) cameras += box.right >= 0;
    CHECK(block.source_count == cameras);
    for (uint32_t i = 0; i < block.source_count; ++i) {
      const LutSource& source = block.sources[i];
      const Box& box = boxes[index][source.camera];
      CHECK(source.x == box.left);
      CHECK(source.y == box.top);
      CHECK(source.width == box.right - box.left + 1);
      CHECK(source.height == box.bottom - box.top + 1);
    }
  }
}

TEST_CASE("the vehicle's rectangle is background and nothing else is") {
  const auto rig = four_cameras({640, 360});
  for (const Eigen::Vector2d& centre : {Eigen::Vector2d(0, 0), {1.2, -0.7}}) {
    auto view = view_of(rig, {333, 217});
    view.centre_m = centre;
    const DecodedLut lut = decode(OwnedLut(rig, view).lut());
    size_t wrong = 0, grey = 0;
    for (int row = 0; row < lut.height; ++row)
      for (int column = 0; column < lut.width; ++column) {
        const bool under = is_under_vehicle(rig.vehicle, view.ground_from_pixel({column, row}));
        wrong += under != (lut.at(column, row).kind == RegionKind::kBackground);
        grey += lut.at(column, row).background[0] > 0;
      }
    CHECK(wrong == 0);
    CHECK(grey > 1000);
  }
}

TEST_CASE("weights change little from pixel to pixel, also where a camera's picture ends") {
  const auto rig = four_cameras({640, 360});
  const auto view = view_of(rig, {440, 540});
  CHECK(largest_jump(decode(OwnedLut(rig, view).lut()), rig, view) <= 20);
  for (const double angle_deg : {60.0, 75.0}) {
    const auto narrow = with_narrow_camera(rig, 0, angle_deg);
    CHECK(largest_jump(decode(OwnedLut(narrow, view).lut()), narrow, view) <= 30);
  }
}

TEST_CASE("a neighbour fills what a camera does not see of its own zone") {
  const auto rig = four_cameras({640, 360});
  const auto narrow = with_narrow_camera(rig, 3, 50);
  const auto view = view_of(rig, {220, 270});
  const DecodedLut lut = decode(OwnedLut(narrow, view).lut());
  size_t filled = 0, black = 0, wrong = 0;
  for (int row = 0; row < lut.height; ++row)
    for (int column = 0; column < lut.width; ++column) {
      const Eigen::Vector2d ground = view.ground_from_pixel({column, row});
      if (std::abs(ground.x()) > 2.4 || ground.y() < 0.95) continue;
      const Eigen::Vector3d point(ground.x(), ground.y(), 0);
      const bool own = narrow.cameras[3].see(point).has_value();
      const auto& other = narrow.cameras[ground.x() >= 0 ? 0 : 2];
      const auto in_neighbour = other.see(point);
      const double past_body =
          sight_past_body(narrow.vehicle, other.vehicle_from_camera.translation.head<2>(), ground);
      const bool neighbour = in_neighbour && in_neighbour->minCoeff() > 1 && in_neighbour->x() < 638 &&
                             in_neighbour->y() < 358 && past_body > 0;  // well within its picture
      const DecodedPixel& pixel = lut.at(column, row);
      if (own) wrong += pixel.tap_count() == 0;
      if (own) continue;
      if (neighbour) (pixel.kind == RegionKind::kCamera && pixel.taps[0].camera != 3 ? filled : wrong) += 1;
      if (!in_neighbour || past_body <= 0) (pixel.kind == RegionKind::kBlack ? black : wrong) += 1;
    }
  CHECK(wrong == 0);
  CHECK(filled > 100);
  CHECK(black > 0);
}

TEST_CASE("a binary blend shows one camera everywhere") {
  const auto rig = four_cameras({640, 360});
  const OwnedLut owned(rig, view_of(rig, {220, 270}), {0});
  CHECK(owned.lut().header().overlap_count == 0);
  CHECK(owned.lut().footprint().blend_blocks == 0);
}

TEST_CASE("smooth and linear weights leave no seam line in a LUT of the shipped rig") {
  const auto rig = shipped_rig("car");
  const auto view = view_of(rig, {440, 540});
  for (const auto curve : {BlendCurve::kSmooth, BlendCurve::kLinear}) {
    CAPTURE(static_cast<int>(curve));
    CHECK(largest_jump(decode(OwnedLut(rig, view, {60, curve}).lut()), rig, view) <= 12);
  }
  CHECK(largest_jump(decode(OwnedLut(rig, view, {60, BlendCurve::kBinary}).lut()), rig, view) == 255);
}

TEST_CASE("a binary blend with a width shows one camera everywhere, and samples both where smooth does") {
  const auto rig = shipped_rig("car");
  const auto view = view_of(rig, {440, 540});
  const OwnedLut smooth(rig, view), binary(rig, view, {60, BlendCurve::kBinary});
  CHECK(binary.lut().header().overlap_count > 20);
  CHECK(binary.lut().header().overlap_count == smooth.lut().header().overlap_count);
  const DecodedLut of_smooth = decode(smooth.lut()), of_binary = decode(binary.lut());
  size_t blends = 0, wrong = 0;
  for (size_t i = 0; i < of_binary.pixels.size(); ++i) {
    const DecodedPixel &shown = of_binary.pixels[i], &mixed = of_smooth.pixels[i];
    wrong += shown.kind != mixed.kind;
    if (shown.kind != RegionKind::kBlend) continue;
    ++blends;
    wrong += shown.weight != (mixed.weight > 127 ? 255 : 0);
    wrong += shown.taps[0].camera != mixed.taps[0].camera || shown.taps[0].px() != mixed.taps[0].px();
  }
  CHECK(wrong == 0);
  CHECK(blends > 1000);
}

TEST_CASE("a LUT reads the same at another address") {
  const auto rig = four_cameras({640, 360});
  const OwnedLut owned(rig, view_of(rig, {220, 270}));
  std::vector<std::byte> moved(owned.bytes().size() + 64);
  std::memcpy(moved.data() + 64, owned.bytes().data(), owned.bytes().size());
  const GeometricLut copy(std::span<const std::byte>(moved).subspan(64));
  const DecodedLut a = decode(owned.lut()), b = decode(copy);
  CHECK(std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), [](auto& p, auto& q) {
    return p.kind == q.kind && p.weight == q.weight && p.background == q.background &&
           p.taps[0].px() == q.taps[0].px() && p.taps[1].py() == q.taps[1].py();
  }));
}

TEST_CASE("a block's rows are what its pixels take of their sources, and no more") {
  const auto rig = four_cameras({640, 360});
  const OwnedLut owned(rig, view_of(rig, {220, 270}));
  const GeometricLut lut = owned.lut();
  size_t listed = 0;
  for (const LutBlock& block : lut.blocks()) {
    std::map<std::array<int, 2>, std::array<int, 2>> expected;  // source and row to first and last pixel
    for_each_pixel(lut, block, [&](const LutPixel& pixel) {
      for (int i = 0; i < pixel.region->tap_count(); ++i) {
        const int source = i == 0 ? pixel.region->first : pixel.region->second;
        const uint32_t entry = i == 0 ? pixel.first : pixel.second;
        const int x = static_cast<int>(entry_x(entry) / 32), y = static_cast<int>(entry_y(entry) / 32);
        for (const int row : {y, y + 1}) {
          const auto found = expected.try_emplace({source, row}, std::array{x, x + 1}).first;
          found->second = {std::min(found->second[0], x), std::max(found->second[1], x + 1)};
        }
      }
    });
    size_t n = 0;
    for (int source = 0; source < int(block.source_count); ++source)
      for (int y = 0; y < block.sources[source].height; ++y, ++n) {
        const LutRow& row = lut.rows(block)[n];
        const auto found = expected.find({source, y});
        REQUIRE((row.count > 0) == (found != expected.end()));
        if (row.count > 0) CHECK(std::array<int, 2>{row.start, row.start + row.count - 1} == found->second);
      }
    CHECK(n == block.row_count);
    listed += n;
  }
  CHECK(listed > 1000);
}

TEST_CASE("memory that holds no whole LUT is refused") {
  const auto rig = four_cameras({640, 360});
  const OwnedLut owned(rig, view_of(rig, {120, 90}));
  std::vector<std::byte> memory(owned.bytes().begin(), owned.bytes().end());
  const auto open = [&] { GeometricLut{std::span<const std::byte>(memory)}; };
  auto& header = *reinterpret_cast<LutHeader*>(memory.data());
  auto* blocks = reinterpret_cast<LutBlock*>(memory.data() + sizeof(LutHeader));
  CHECK_NOTHROW(open());

  SECTION("truncated") {
    memory.pop_back();
  }
  SECTION("without a header") {
    memory.erase(memory.begin() + 8, memory.end());
  }
  SECTION("something else") {
    header.magic ^= 1;
  }
  SECTION("of another version") {
    ++header.version;
  }
  SECTION("with another number of blocks") {
    ++header.block_count;
  }
  SECTION("with entries beyond the end") {
    blocks[2].entries_at = header.bytes;
  }
  SECTION("with an endless list of spans") {
    blocks[2].span_count = 0xFFFFFFFF;
  }
  SECTION("with an endless list of regions") {
    blocks[2].region_count = 0xFFFFFFFF;
  }
  SECTION("with an endless list of rows") {
    blocks[2].row_count = 0xFFFFFFFF;
  }
  SECTION("with rows that are wider than their box") {
    reinterpret_cast<LutRow*>(memory.data() + blocks[0].rows_at)->count = 2000;
  }
  SECTION("with a span beyond its block") {
    reinterpret_cast<LutSpan*>(memory.data() + blocks[0].spans_at)->start = 39;
  }
  SECTION("with a region that has not the pixels of its spans") {
    reinterpret_cast<LutRegion*>(memory.data() + blocks[0].regions_at)->pixels += 1;
  }
  SECTION("with a region of a camera that the block does not take") {
    reinterpret_cast<LutRegion*>(memory.data() + blocks[0].regions_at)->first = 4;
  }
  SECTION("with a box beyond the image") {
    blocks[0].sources[0].x = 639;
  }
  SECTION("with a camera too many") {
    blocks[0].sources[0].camera = 4;
  }
  SECTION("with a block beyond the view") {
    blocks[2].x = 100;
  }
  CHECK_THROWS_AS(open(), std::invalid_argument);
}

TEST_CASE("what cannot be built is refused by name") {
  auto rig = four_cameras({640, 360});
  auto view = view_of(rig, {120, 90});
  std::vector<std::byte> memory(geometric_lut_capacity(view, 4));
  const auto complaint = [&](double width_deg, std::span<std::byte> into) -> std::string {
    try {
      build_geometric_lut(rig, view, {width_deg}, into);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const auto says = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  CHECK(complaint(60, memory).empty());
  CHECK(says(complaint(120, memory), "120"));
  CHECK(says(complaint(120, memory), "0 to 90"));
  CHECK(says(complaint(60, std::span<std::byte>(memory).first(5000)), "memory"));
  view.metres_per_px = 0;
  CHECK(says(complaint(60, memory), "view"));
  view.metres_per_px = 0.05;
  rig.cameras.pop_back();
  CHECK(says(complaint(60, memory), "four cameras"));
}
