#include "algorithms/bowl/mesh_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/bowl/owned_mesh.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

struct StoredMesh {
  geometry::Rig rig = four_cameras({640, 360});
  BowlSurface surface = default_surface(rig.vehicle);
  synthesis::BlendShape shape;
  OwnedMesh made = OwnedMesh(rig, surface, shape, 3);
  TemporaryFolder folder;
  fs::path path = folder.path() / "car.mesh";

  StoredMesh() { write_mesh_file(path, made.table()); }

  std::string faults() const {
    const auto read = read_mesh_file(path, rig, surface, shape);
    std::string text;
    if (!read) {
      for (const Fault& fault : read.error()) text += fault.text() + "\n";
    }
    return text;
  }
};

}  // namespace

TEST_CASE("a mesh table that was written is read again byte by byte") {
  StoredMesh stored;
  stored.rig.calibration = "{\"accepted\": true}";  // what a calibration says of itself changes nothing
  const auto read = read_mesh_file(stored.path, stored.rig, stored.surface, stored.shape);
  REQUIRE(read);
  CHECK(std::ranges::equal(*read, stored.made.table().bytes()));
  CHECK(std::distance(fs::directory_iterator(stored.folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("a mesh table of another rig, surface or blend is refused with all that differs at once") {
  StoredMesh stored;
  stored.rig.cameras[2].vehicle_from_camera.translation.z() += 1e-6;
  stored.surface.shape = FloorShape::kEllipse;
  stored.surface.height_m += 1;
  stored.shape.width_deg = 30;
  stored.shape.curve = synthesis::BlendCurve::kLinear;
  const std::string faults = stored.faults();
  CHECK_THAT(faults, Contains("another rig") && Contains("an ellipse, as expected"));
  CHECK_THAT(faults, Contains("height_m is 2.3999999999999999, expected 3.3999999999999999"));
  CHECK_THAT(faults, Contains("width in degrees is 60, expected 30") && Contains("another curve"));
  CHECK(std::count(faults.begin(), faults.end(), '\n') == 5);
}

TEST_CASE("a mesh file that is missing, cut short, changed or none at all is refused") {
  StoredMesh stored;
  {
    std::fstream file(stored.path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(5000);
    file.put(file.peek() == 1 ? 2 : 1);
    file.seekp(5001);
    file.put('x');
  }
  CHECK_THAT(stored.faults(), Contains("checksum"));
  fs::resize_file(stored.path, fs::file_size(stored.path) - 1);
  CHECK_THAT(stored.faults(), Contains("car.mesh") && Contains("cut short"));
  std::ofstream(stored.path) << "{\"vehicle\": {}, \"what\": \"a rig, and not a mesh at all, by mistake\"}";
  CHECK_THAT(stored.faults(), Contains("is no mesh file"));
  fs::remove(stored.path);
  CHECK_THAT(stored.faults(), Contains("No such file"));
  const fs::path nowhere = stored.folder.path() / "no_such_folder" / "car.mesh";
  CHECK_THROWS_WITH(write_mesh_file(nowhere, stored.made.table()), Contains(nowhere.string()));
}
