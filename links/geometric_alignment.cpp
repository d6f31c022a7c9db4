#include "links/geometric_alignment.h"

#include "algorithms/synthesis/geometric_lut.h"
#include "framework/link/call.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kFrames = 0;
constexpr int kLut = 0;

class GeometricAlignment final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "geometric_alignment";
    d.help = "makes the geometric and blending LUT of the rig, once, on the first frames";
    d.inputs = {
        {.name = "frames", .types = {"bgr8"}, .count = 4, .help = "sets of four, front right rear left"}};
    d.outputs = {{.name = "lut",
                  .types = {"geometric_lut"},
                  .count = 1,
                  .help = "where every output pixel comes from"}};
    d.parameters = {
        choice("source", "rig", {"rig"}, "what the cameras' poses are taken from"),
        number("blend_deg", synthesis::BlendShape{}.width_deg, {0, 90}, "deg",
               "angle around the vehicle's corner over which two cameras blend; 0: a hard seam"),
    };
    return d;
  }

  void configure(Configuration& configuration) override {
    auto rig = rig_in_use(configuration);
    if (!rig) return configuration.faults(rig.error());
    rig_ = std::move(*rig);
    view_ = view_in_use(configuration, rig_.vehicle);
    shape_.width_deg = configuration.parameters().number("blend_deg");
    check_sizes(configuration);
    configuration.output(
        kLut,
        {Format::table("geometric_lut", synthesis::geometric_lut_capacity(view_, rig_.cameras.size()))});
    made_ = false;
  }

  void check(Configuration& configuration) override {
    if (const auto rig = rig_in_use(configuration); !rig) configuration.faults(rig.error());
  }

  void process(Call& call) override {
    if (made_) return;
    Draft lut = call.create(kLut);
    synthesis::build_geometric_lut(rig_, view_, shape_, lut.bytes());
    footprint_ = synthesis::GeometricLut(lut.bytes()).footprint();
    call.send(kLut, std::move(lut));
    made_ = true;
  }

  void report(nlohmann::json& report) const override {
    report["view"] = {{"size_px", {view_.size_px.x(), view_.size_px.y()}},
                      {"metres_per_px", view_.metres_per_px},
                      {"centre_m", {view_.centre_m.x(), view_.centre_m.y()}}};
    if (!made_) return;
    report["lut"] = {{"bytes", footprint_.bytes},
                     {"bytes_per_px", footprint_.bytes_per_pixel},
                     {"source_px", footprint_.source_pixels},
                     {"blocks",
                      {{"empty", footprint_.empty_blocks},
                       {"one_camera", footprint_.one_camera_blocks},
                       {"blend", footprint_.blend_blocks}}}};
  }

 private:
  void check_sizes(Configuration& configuration) const {
    const PortFormat& frames = configuration.input(kFrames);
    for (size_t c = 0; c < rig_.cameras.size() && c < frames.size(); ++c) {
      const auto& camera = rig_.cameras[c];
      const auto text = [](int width, int height) {
        return std::to_string(width) + "x" + std::to_string(height);
      };
      if (frames[c].width_px == camera.image_size_px.x() && frames[c].height_px == camera.image_size_px.y())
        continue;
      configuration.format_fault(
          kFrames, "size of " + camera.name,
          text(camera.image_size_px.x(), camera.image_size_px.y()) + ", as the rig has it",
          text(frames[c].width_px, frames[c].height_px));
    }
  }

  geometry::Rig rig_;
  geometry::View view_;
  synthesis::BlendShape shape_;
  synthesis::GeometricLut::Footprint footprint_;
  bool made_ = false;
};

}  // namespace

std::unique_ptr<Link> make_geometric_alignment() {
  return std::make_unique<GeometricAlignment>();
}

}  // namespace svchain
