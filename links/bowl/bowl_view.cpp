#include "links/bowl/bowl_view.h"

#include <optional>
#include <stdexcept>

#include "framework/link/call.h"
#include "links/bowl/bowl_painter.h"
#include "links/bowl/bowl_settings.h"
#include "links/bowl/view_inputs.h"
#include "links/bowl/viewpoint_settings.h"
#include "links/image.h"
#include "links/picture_parameters.h"
#include "links/rig_table.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kFrames = 0, kToneMapping = 1, kRig = 2;
constexpr int kView = 0;

class BowlView final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "bowl_view";
    d.help = "shows the world around the vehicle as a bowl, from any viewpoint, the car in its middle";
    d.inputs = view_inputs();
    d.inputs.push_back({.name = "rig",
                        .types = {"rig"},
                        .count = 1,
                        .intake = Intake::kState,
                        .help = "the calibrated cameras, in force until the next"});
    d.outputs = {{.name = "view", .types = {"bgr8"}, .count = 1, .help = "the picture"}};
    d.parameters = viewpoint_parameters();
    return d;
  }

  void configure(Configuration& configuration) override {
    pixels_ = configuration.pace().pixels;
    check_colours(configuration, kFrames);
    const Eigen::Vector2i size_px = view_size_px(configuration);
    configuration.output(kView, {Format::bgr8(size_px.x(), size_px.y())});
    painter_.emplace(size_px);
    read_settings(configuration);
    rig_at_ = nullptr;
    inputs_ = {};
    frames_ = 0;
  }

  void check(Configuration& configuration) override { read_settings(configuration); }

  void process(Call& call) override {
    if (!pixels_) return call.send(kView, call.create(kView));
    follow_rig(call.input(kRig));
    const double time_s = inputs_.take(call, kFrames, kToneMapping);
    Draft view = call.create(kView);
    cv::Mat picture = bgr_picture(view);
    painter_->paint(inputs_.frames, inputs_.tone_mapping, motion_.at(time_s), picture, call);
    call.send(kView, std::move(view));
    ++frames_;
  }

  nlohmann::json control(const std::string& command, const nlohmann::json& arguments) override {
    if (command == "viewpoint") return motion_.go_to(arguments);
    if (command == "bowl") return change_surface(arguments);
    throw std::invalid_argument("no command \"" + command + "\", expected viewpoint or bowl");
  }

  void report(nlohmann::json& report) const override {
    if (!painter_ || !pixels_) return;
    report["bowl_view"] = {{"renderer", "cpu"},
                           {"frames", frames_},
                           {"luts", painter_->luts()},
                           {"lut_bytes", painter_->lut_bytes()}};
  }

 private:
  void read_settings(Configuration& configuration) {
    const auto rig = nominal_rig_in_use(configuration);
    if (!rig) return configuration.faults(rig.error());
    vehicle_ = rig->vehicle;
    surface_ = surface_in_use(configuration, vehicle_);
    shape_ = bowl_blend_in_use(configuration);
    motion_.configure(configuration, vehicle_, surface_);
    auto model = car_in_use(configuration, vehicle_);
    if (model && painter_) painter_->set_car(std::move(*model), vehicle_, car_opacity_in_use(configuration));
  }

  nlohmann::json change_surface(const nlohmann::json& arguments) {
    surface_ = changed(surface_, arguments, vehicle_);
    motion_.follow(surface_);
    rig_at_ = nullptr;  // the next frame makes all anew
    return {{"bowl", "with the next frame"}};
  }

  void follow_rig(const Frame& frame) {
    if (rig_at_ == frame.bytes().data()) return;
    painter_->set_world(read_rig_table(frame.bytes()), surface_, shape_);
    rig_at_ = frame.bytes().data();
  }

  bool pixels_ = true;
  geometry::Vehicle vehicle_;
  bowl::BowlSurface surface_;
  synthesis::BlendShape shape_;
  ViewpointMotion motion_;
  std::optional<BowlPainter> painter_;
  const std::byte* rig_at_ = nullptr;
  ViewInputs inputs_;
  uint64_t frames_ = 0;
};

}  // namespace

std::unique_ptr<Link> make_bowl_view() {
  return std::make_unique<BowlView>();
}

}  // namespace svchain
