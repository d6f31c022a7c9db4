#include "links/bowl/mesh_table.h"

#include <cstring>
#include <stdexcept>

#include "algorithms/bowl/mesh_file.h"
#include "framework/link/call.h"
#include "links/bowl/bowl_settings.h"
#include "links/rig_table.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kFrames = 0, kRig = 1;
constexpr int kMesh = 0;

class MeshTableLink final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "mesh_table";
    d.help =
        "makes the bowl's mesh table from the calibrated cameras, and again when they or the bowl change";
    d.inputs = {
        {.name = "frames", .help = "any; with each of them is seen whether something has changed"},
        {.name = "rig", .types = {"rig"}, .count = 1, .intake = Intake::kState, .help = "the cameras"}};
    d.outputs = {{.name = "mesh",
                  .types = {"mesh_table", "rig"},
                  .count = 2,
                  .help = "triangles of the bowl, and the cameras they were made for"}};
    d.parameters = {
        number("tolerance_px", bowl::kDefaultTolerancePx, {0.05, 50}, "px",
               "how far texture may be off within a triangle, in a camera's image"),
        path("store", "file that keeps the mesh table to the next start; made anew where it does not fit")};
    return d;
  }

  void configure(Configuration& configuration) override {
    pixels_ = configuration.pace().pixels;
    read_settings(configuration);
    tolerance_px_ = configuration.parameters().number("tolerance_px");
    store_ = configuration.parameters().text("store");
    rig_at_ = nullptr;
    meshes_ = reloaded_ = 0;
  }

  void check(Configuration& configuration) override { read_settings(configuration); }

  void process(Call& call) override {
    const Frame& input = call.input(kRig);
    if (input.bytes().data() == rig_at_) return;
    Draft mesh = call.create(kMesh);
    if (pixels_) {
      const geometry::Rig rig = read_rig_table(input.bytes());
      make(rig, mesh.bytes(0));
      write_rig(rig, mesh.bytes(1));
    }
    call.send(kMesh, std::move(mesh));
    rig_at_ = input.bytes().data();
  }

  nlohmann::json control(const std::string& command, const nlohmann::json& arguments) override {
    if (command != "bowl") throw std::invalid_argument("no command \"" + command + "\", expected bowl");
    surface_ = changed(surface_, arguments, vehicle_);
    rig_at_ = nullptr;
    return {{"bowl", "with the next frame"}};
  }

  void report(nlohmann::json& report) const override {
    if (meshes_ == 0) return;
    report["mesh_table"] = {{"bytes", size_.bytes},          {"vertices", size_.vertices},
                            {"triangles", size_.triangles},  {"bytes_per_vertex", sizeof(bowl::MeshVertex)},
                            {"tolerance_px", tolerance_px_}, {"made", meshes_ - reloaded_},
                            {"reloaded", reloaded_}};
  }

 private:
  struct Size {
    uint32_t bytes = 0, vertices = 0, triangles = 0;
  };

  void read_settings(Configuration& configuration) {
    const auto rig = nominal_rig_in_use(configuration);
    if (!rig) return configuration.faults(rig.error());
    vehicle_ = rig->vehicle;
    configuration.output(kMesh, {Format::table("mesh_table", bowl::mesh_table_capacity()), rig_format(*rig)});
    surface_ = surface_in_use(configuration, vehicle_);
    shape_ = bowl_blend_in_use(configuration);
  }

  void make(const geometry::Rig& rig, std::span<std::byte> memory) {
    if (!reload(rig, memory)) {
      bowl::build_mesh_table(rig, surface_, shape_, tolerance_px_, memory);
      if (!store_.empty()) bowl::write_mesh_file(store_, bowl::MeshTable(memory));
    }
    const bowl::MeshHeader& header = bowl::MeshTable(memory).header();
    size_ = {header.bytes, header.vertex_count, header.index_count / 3};
    ++meshes_;
  }

  bool reload(const geometry::Rig& rig, std::span<std::byte> memory) {
    if (store_.empty()) return false;
    const auto kept = bowl::read_mesh_file(store_, rig, surface_, shape_);
    if (!kept || bowl::MeshTable(*kept).header().tolerance_px != tolerance_px_) return false;
    std::memcpy(memory.data(), kept->data(), kept->size());
    ++reloaded_;
    return true;
  }

  bool pixels_ = true;
  geometry::Vehicle vehicle_;
  bowl::BowlSurface surface_;
  synthesis::BlendShape shape_;
  double tolerance_px_ = 0;
  std::string store_;
  const std::byte* rig_at_ = nullptr;
  Size size_;
  uint64_t meshes_ = 0, reloaded_ = 0;
};

}  // namespace

std::unique_ptr<Link> make_mesh_table() {
  return std::make_unique<MeshTableLink>();
}

}  // namespace svchain
