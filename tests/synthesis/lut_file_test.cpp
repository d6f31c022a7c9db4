#include "algorithms/synthesis/lut_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

struct Stored {
  geometry::Rig rig = four_cameras({640, 360});
  geometry::View view = view_of(rig, {120, 160});
  OwnedLut made = OwnedLut(rig, view);
  TemporaryFolder folder;
  fs::path path = folder.path() / "car.lut";

  Stored() { write_lut_file(path, made.bytes()); }

  /// All faults, one a line; "" where it can be read.
  std::string faults() const {
    const auto read = read_lut_file(path, rig, view);
    std::string text;
    if (!read) {
      for (const Fault& fault : read.error()) text += fault.text() + "\n";
    }
    return text;
  }
  void change(size_t at) const {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekg(static_cast<std::streamoff>(at));
    const int was = file.get();
    file.seekp(static_cast<std::streamoff>(at));
    file.put(static_cast<char>(was ^ 1));
  }
};

}  // namespace

TEST_CASE("a LUT that was written is read again byte by byte, and nothing else is left in the folder") {
  const Stored stored;
  const auto read = read_lut_file(stored.path, stored.rig, stored.view);
  REQUIRE(read);
  CHECK(std::ranges::equal(*read, stored.made.bytes()));
  CHECK(std::distance(fs::directory_iterator(stored.folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("writing again replaces the LUT that was there") {
  Stored stored;
  stored.view = view_of(stored.rig, {80, 100});
  CHECK(stored.faults() != "");
  write_lut_file(stored.path, OwnedLut(stored.rig, stored.view).bytes());
  CHECK(stored.faults() == "");
}

TEST_CASE("a LUT that cannot be written is an error that names the path, and leaves nothing") {
  const Stored stored;
  const fs::path nowhere = stored.folder.path() / "no_such_folder" / "car.lut";
  CHECK_THROWS_WITH(write_lut_file(nowhere, stored.made.bytes()),
                    Contains(nowhere.string()) && Contains("No such file or directory"));
  const fs::path folder = stored.folder.path() / "folder";
  fs::create_directories(folder / "full");
  CHECK_THROWS_WITH(write_lut_file(folder, stored.made.bytes()), Contains(folder.string()));
  CHECK(std::distance(fs::directory_iterator(stored.folder.path()), fs::directory_iterator()) == 2);
}

TEST_CASE("what is no LUT file is told from one that is missing, a folder, too short or too long") {
  Stored stored;
  fs::resize_file(stored.path, fs::file_size(stored.path) - 1);
  CHECK_THAT(stored.faults(), Contains("car.lut") && Contains("cut short"));
  fs::resize_file(stored.path, fs::file_size(stored.path) + 2);
  CHECK_THAT(stored.faults(), Contains("bytes long, expected") && !Contains("cut short"));
  fs::resize_file(stored.path, 20);
  CHECK_THAT(stored.faults(), Contains("no LUT file"));
  std::ofstream(stored.path) << "{\"vehicle\": {}, \"what\": \"a rig, and not a LUT at all, by mistake\"}";
  CHECK_THAT(stored.faults(), Contains("no LUT file"));
  fs::remove(stored.path);
  CHECK_THAT(stored.faults(), Contains("No such file"));
  fs::create_directory(stored.path);
  CHECK_THAT(stored.faults(), Contains("is a folder"));
}

TEST_CASE("a single bit that has changed anywhere in a LUT file is found") {
  for (const size_t at : {size_t{3}, size_t{8}, size_t{17}, size_t{25}, size_t{40}, size_t{2000}}) {
    const Stored stored;
    stored.change(at);
    CAPTURE(at);
    CHECK(stored.faults() != "");
  }
  const Stored version, content;
  version.change(8);
  CHECK_THAT(version.faults(), Contains("version 0, expected 1"));
  content.change(2000);
  CHECK_THAT(content.faults(), Contains("checksum"));
}

TEST_CASE("a LUT for another view or other cameras is refused with all that differs at once") {
  Stored stored;
  stored.view.size_px = {880, 1080};
  stored.view.metres_per_px *= 2;
  stored.view.centre_m = {0.5, 0};
  stored.rig.cameras[2].image_size_px = {1280, 720};
  const std::string faults = stored.faults();
  CHECK_THAT(faults, Contains("120 x 160 px, expected 880 x 1080 px"));
  CHECK_THAT(faults, Contains("m a pixel, expected"));
  CHECK_THAT(faults, Contains("centre of its view is 0, 0 m, expected 0.5, 0"));
  CHECK_THAT(faults, Contains("camera rear are 640 x 360 px, expected 1280 x 720 px"));
  CHECK(std::count(faults.begin(), faults.end(), '\n') == 4);
}
