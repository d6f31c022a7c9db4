#include "links/bowl/bowl_view.h"

#include <array>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "algorithms/bowl/viewpoint_lut.h"
#include "algorithms/car/car_picture.h"
#include "algorithms/synthesis/synthesize.h"
#include "framework/link/call.h"
#include "links/bowl/bowl_settings.h"
#include "links/bowl/viewpoint_settings.h"
#include "links/image.h"
#include "links/picture_parameters.h"
#include "links/rig_table.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kFrames = 0, kRig = 1, kToneMapping = 2;
constexpr int kView = 0;
constexpr size_t kCameraCount = 4;
constexpr int kPartsPerCpu = 4;  // they differ in cost

car::Viewpoint pinhole_of(const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px) {
  const bowl::Perspective perspective(viewpoint, size_px);
  car::Viewpoint pinhole;
  pinhole.camera_from_vehicle = perspective.vehicle_from_picture().transpose();
  pinhole.eye = perspective.eye();
  pinhole.focal_px = perspective.focal_px();
  pinhole.centre_px = (size_px.cast<double>().array() - 1) / 2;
  pinhole.size_px = size_px;
  return pinhole;
}

class BowlView final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "bowl_view";
    d.help = "shows the world around the vehicle as a bowl, from any viewpoint, the car in its middle";
    d.inputs = {{.name = "frames",
                 .types = {"bgr8", "nv12", "yuyv"},
                 .count = kCameraCount,
                 .help = "sets of four, front right rear left"},
                {.name = "rig",
                 .types = {"rig"},
                 .count = 1,
                 .intake = Intake::kState,
                 .help = "the calibrated cameras, in force until the next"},
                {.name = "tone_mapping",
                 .types = {"tone_mapping"},
                 .count = 1,
                 .optional = true,
                 .help = "applied to the next frame; the identity before the first"}};
    d.outputs = {{.name = "view", .types = {"bgr8"}, .count = 1, .help = "the picture"}};
    d.parameters = viewpoint_parameters();
    return d;
  }

  void configure(Configuration& configuration) override {
    check_colours(configuration, kFrames);
    size_px_ = view_size_px(configuration);
    configuration.output(kView, {Format::bgr8(size_px_.x(), size_px_.y())});
    read_settings(configuration);
    lut_memory_.resize(bowl::ViewpointLut::capacity(size_px_));
    lut_.reset();
    maker_.reset();
    rig_at_ = nullptr;
    first_ns_.reset();
    tone_mapping_ = synthesis::ToneMapping::identity();
    luts_ = frames_ = 0;
  }

  void check(Configuration& configuration) override { read_settings(configuration); }

  void process(Call& call) override {
    if (const Frame& curves = call.input(kToneMapping))
      std::memcpy(&tone_mapping_, curves.bytes().data(), sizeof(tone_mapping_));
    const Frame& set = call.input(kFrames);
    follow_rig(call.input(kRig));
    look_from(motion_.at(time_s(set)), call);
    Draft view = call.create(kView);
    cv::Mat picture = bgr_picture(view);
    show(set, picture, call);
    if (car_) car_->blend_over(picture);
    call.send(kView, std::move(view));
    ++frames_;
  }

  nlohmann::json control(const std::string& command, const nlohmann::json& arguments) override {
    if (command == "viewpoint") return motion_.go_to(arguments);
    if (command == "bowl") return change_surface(arguments);
    throw std::invalid_argument("no command \"" + command + "\", expected viewpoint or bowl");
  }

  void report(nlohmann::json& report) const override {
    report["bowl_view"] = {{"renderer", "cpu"}, {"frames", frames_}, {"luts", luts_}};
    if (lut_) report["bowl_view"]["lut_bytes"] = lut_->header().bytes;
  }

 private:
  void read_settings(Configuration& configuration) {
    const auto rig = nominal_rig_in_use(configuration);
    if (!rig) return configuration.faults(rig.error());
    vehicle_ = rig->vehicle;
    surface_ = surface_in_use(configuration, vehicle_);
    shape_ = bowl_blend_in_use(configuration);
    motion_.configure(configuration, vehicle_, surface_);
    car_opacity_ = car_opacity_in_use(configuration);
    auto model = car_in_use(configuration, vehicle_);
    car_.reset();
    if (model) car_.emplace(std::move(*model), vehicle_);
  }

  nlohmann::json change_surface(const nlohmann::json& arguments) {
    surface_ = changed(surface_, arguments, vehicle_);
    motion_.follow(surface_);
    rig_at_ = nullptr;  // the next frame makes all anew
    return {{"bowl", "with the next frame"}};
  }

  double time_s(const Frame& set) {
    if (!first_ns_) first_ns_ = set.timestamp_ns();
    return static_cast<double>(set.timestamp_ns() - *first_ns_) * 1e-9;
  }

  void follow_rig(const Frame& frame) {
    if (rig_at_ == frame.bytes().data()) return;
    maker_.emplace(read_rig_table(frame.bytes()), surface_, shape_);
    rig_at_ = frame.bytes().data();
    lut_.reset();
  }

  /// A viewpoint that stays has its LUT and its picture of the car already.
  void look_from(const bowl::Viewpoint& viewpoint, Call& call) {
    if (lut_ && viewpoint == shown_) return;
    const int parts = std::min(call.cpus() * kPartsPerCpu, bowl::ViewpointLut::kMostParts);
    maker_->begin(viewpoint, size_px_, lut_memory_);
    if (car_) car_->begin(pinhole_of(viewpoint, size_px_), car_opacity_);
    call.parallel(parts, [&](int i) { maker_->make_nodes(i, parts); });
    call.parallel(parts, [&](int i) { maker_->write_blocks(i, parts); });
    lut_.emplace(std::span(lut_memory_).first(maker_->finish(parts)));
    if (car_) call.parallel(parts, [&](int i) { car_->draw(i, parts); });
    shown_ = viewpoint;
    ++luts_;
  }

  void show(const Frame& set, cv::Mat& picture, Call& call) const {
    std::array<colour::Picture, kCameraCount> frames;
    for (size_t c = 0; c < kCameraCount; ++c) frames[c] = any_picture(set, static_cast<int>(c));
    const colour::Picture target = colour::bgr_picture(picture);
    const int parts = call.cpus() > 1 ? call.cpus() * kPartsPerCpu : 1;
    call.parallel(parts, [&](int i) {
      synthesis::synthesize_part({i, parts}, *lut_, frames, tone_mapping_, target, nullptr, kernel_);
    });
  }

  const synthesis::Kernel kernel_ = synthesis::best_kernel();
  Eigen::Vector2i size_px_ = {0, 0};
  geometry::Vehicle vehicle_;
  bowl::BowlSurface surface_;
  synthesis::BlendShape shape_;
  ViewpointMotion motion_;
  std::optional<car::CarPicture> car_;
  float car_opacity_ = 1;
  std::optional<bowl::ViewpointLut> maker_;  // for the rig in force
  const std::byte* rig_at_ = nullptr;
  std::vector<std::byte> lut_memory_;
  std::optional<synthesis::GeometricLut> lut_;  // of the viewpoint shown
  bowl::Viewpoint shown_;
  std::optional<int64_t> first_ns_;
  synthesis::ToneMapping tone_mapping_;
  uint64_t luts_ = 0, frames_ = 0;
};

}  // namespace

std::unique_ptr<Link> make_bowl_view() {
  return std::make_unique<BowlView>();
}

}  // namespace svchain
