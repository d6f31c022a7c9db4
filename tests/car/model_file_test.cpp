#include "algorithms/car/model_file.h"

#include <random>

#include "tests/car/small_models.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::car;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

const Orientation kVehicleAxes = {Axis::kPlusX, Axis::kPlusZ};

std::string fault_of(const std::filesystem::path& path) {
  const Result<CarModel> model = read_car_model(path);
  REQUIRE_FALSE(model);
  CHECK(model.error().front().file == path.string());
  return model.error().front().text();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// Every read ends, with a model whose indices are valid or with faults.
void read_damaged(const std::filesystem::path& original, const std::filesystem::path& damaged) {
  const std::string text = file_text(original);
  std::mt19937 random(7);
  size_t refused = 0;
  for (int round = 0; round < 600; ++round) {
    std::string copy = text;
    if (round % 3 == 0) copy.resize(random() % copy.size());
    if (round % 3 != 0 && !copy.empty())
      for (uint32_t flips = 1 + random() % 4; flips > 0; --flips)
        copy[random() % copy.size()] ^= static_cast<char>(1 << random() % 8);
    write_text(damaged, copy);
    const Result<CarModel> model = read_car_model(damaged);
    refused += !model;
    if (!model) continue;
    for (const uint32_t index : model->indices) REQUIRE(index < model->vertices.size());
    for (const Vertex& vertex : model->vertices) REQUIRE(vertex.position.allFinite());
  }
  CHECK(refused > 50);
}

}  // namespace

TEST_CASE("an OBJ file gives its triangles, colours and panes") {
  const TemporaryFolder folder;
  write_obj(folder.path() / "small.obj");
  const auto model = read_car_model(folder.path() / "small.obj", kVehicleAxes);
  REQUIRE(model);
  CHECK(model->triangle_count() == 4);
  const Eigen::AlignedBox3f box = bounding_box(*model);
  CHECK(box.min() == Eigen::Vector3f(0, 0, 0));
  CHECK(box.max() == Eigen::Vector3f(1, 1, 2));
  REQUIRE(model->parts.size() == 2);
  const Material &paint = model->parts[0].material, &window = model->parts[1].material;
  CHECK(paint.name == "paint");
  CHECK(paint.base_colour == Eigen::Vector3f(0.5f, 0.25f, 0.125f));
  CHECK(paint.gloss == Approx(0.95));
  CHECK(window.name == "window");
  CHECK_FALSE(window.opaque());
  for (const Vertex& v : model->vertices) CHECK(v.normal.norm() == Approx(1));
}

TEST_CASE("an OBJ file without its material file has no colours but is a model") {
  const TemporaryFolder folder;
  write_obj(folder.path() / "small.obj");
  std::filesystem::remove(folder.path() / "small.mtl");
  const auto model = read_car_model(folder.path() / "small.obj");
  REQUIRE(model);
  CHECK(model->triangle_count() == 4);
  CHECK(model->parts[0].material.name == "plain");
}

TEST_CASE("glTF files give their triangles where their nodes put them, binary or not") {
  const TemporaryFolder folder;
  for (const char* name : {"small.gltf", "small.glb"}) {
    write_gltf(folder.path() / name);
    const auto model = read_car_model(folder.path() / name, kVehicleAxes);
    REQUIRE(model);
    CHECK(model->triangle_count() == 2);
    const Eigen::AlignedBox3f box = bounding_box(*model);
    CHECK(box.min().isApprox(Eigen::Vector3f(0, 1, 0)));
    CHECK(box.max().isApprox(Eigen::Vector3f(2, 3, 4)));
    REQUIRE(model->parts.size() == 2);
    CHECK(model->parts[0].material.name == "paint");
    CHECK(model->parts[0].material.metallic == 0.5f);
    CHECK(model->parts[0].material.gloss == 0.75f);
    CHECK(model->parts[1].material.name == "pane");
    CHECK(model->parts[1].material.opacity == 0.25f);
  }
}

TEST_CASE("a model is turned from its file's axes to the vehicle's") {
  const TemporaryFolder folder;
  write_obj(folder.path() / "small.obj");
  const auto usual = read_car_model(folder.path() / "small.obj");  // z forward, y up, so x left
  REQUIRE(usual);
  CHECK(bounding_box(*usual).max() == Eigen::Vector3f(2, 1, 1));
  const auto other = read_car_model(folder.path() / "small.obj", {Axis::kMinusY, Axis::kPlusZ});  // x left
  REQUIRE(other);
  CHECK(bounding_box(*other).min() == Eigen::Vector3f(-1, 0, 0));
  CHECK(bounding_box(*other).max() == Eigen::Vector3f(0, 1, 2));
}

TEST_CASE("what is no model is refused by name, with what was expected") {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& name, const std::string& text) {
    write_text(folder.path() / name, text);
    return folder.path() / name;
  };
  CHECK_THAT(fault_of(folder.path() / "none.obj"), Contains("none.obj") && Contains("does not exist"));
  CHECK_THAT(fault_of(file("car.txt", "hello")), Contains(".obj, .gltf or .glb"));
  CHECK_THAT(fault_of(file("empty.obj", "")), Contains("no triangles"));
  CHECK_THAT(fault_of(file("empty.gltf", "")), Contains("is not a model"));
  CHECK_THAT(fault_of(file("short.glb", "glTF")), Contains("header"));
  CHECK_THAT(fault_of(file("bare.gltf", R"({"asset":{"version":"2.0"}})")), Contains("no triangles"));
  CHECK_THAT(fault_of(file("deep.gltf", std::string(100000, '['))), Contains("nested"));
  CHECK_THAT(fault_of(file("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")), Contains("out of range"));
  CHECK_THAT(fault_of(file("nan.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n")), Contains("nowhere"));
  CHECK_THAT(fault_of(file("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")), Contains("no triangles"));
  std::filesystem::create_directory(folder.path() / "folder.obj");
  CHECK_THAT(fault_of(folder.path() / "folder.obj"), Contains("is not a file"));
}

TEST_CASE("glTF that promises what it does not have is refused") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "small.gltf";
  write_gltf(path);
  const std::string text = file_text(path);
  const auto fault = [&](const std::string& from, const std::string& to) {
    write_text(path, replaced(text, from, to));
    return fault_of(path);
  };
  CHECK_THAT(fault("\"count\":3", "\"count\":4000000000"), Contains("out of range"));
  CHECK_THAT(fault("\"bufferView\":1,\"byteOffset\":6", "\"bufferView\":1,\"byteOffset\":60"),
             Contains("out of range"));
  CHECK_THAT(fault("\"byteOffset\":72", "\"byteOffset\":73"), Contains("out of range"));
  CHECK_THAT(fault("\"indices\":2", "\"indices\":7"), Contains("out of bounds"));
  CHECK_THAT(fault("\"children\":[1]", "\"children\":[0]"), Contains("without end"));
  CHECK_THAT(fault("\"mesh\":0", "\"mesh\":5"), Contains("out of range"));
}

TEST_CASE("models with too many triangles or bytes are refused") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "huge.obj";
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  text.reserve(17u << 20);
  for (size_t i = 0; i <= kMostTriangles; ++i) text += "f 1 2 3\n";
  write_text(path, text);
  CHECK_THAT(fault_of(path), Contains("2000000 triangles"));
  std::filesystem::resize_file(path, kLargestFile + 1);  // a sparse file
  CHECK_THAT(fault_of(path), Contains("256 MB"));
}

TEST_CASE("damaged models are read or refused, and nothing worse") {
  const TemporaryFolder folder;
  write_obj(folder.path() / "small.obj");
  write_gltf(folder.path() / "small.gltf");
  write_gltf(folder.path() / "small.glb");
  for (const char* extension : {"obj", "gltf", "glb"})
    read_damaged(folder.path() / (std::string("small.") + extension),
                 folder.path() / (std::string("damaged.") + extension));
}
