#include "links/bowl/bowl_view_gl.h"

#include <optional>
#include <stdexcept>

#include "framework/link/call.h"
#include "links/bowl/bowl_settings.h"
#include "links/bowl/gl_painter.h"
#include "links/bowl/view_inputs.h"
#include "links/bowl/viewpoint_settings.h"
#include "links/image.h"
#include "links/picture_parameters.h"
#include "links/rig_table.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kFrames = 0, kToneMapping = 1, kMesh = 2;
constexpr int kView = 0;
constexpr const char *kByCpu = "cpu", *kStop = "stop";

class BowlViewGl final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "bowl_view_gl";
    d.help = "shows the world around the vehicle as a bowl by OpenGL ES 3, with or without a GPU";
    d.inputs = view_inputs();
    d.inputs.push_back({.name = "mesh",
                        .types = {"mesh_table", "rig"},
                        .count = 2,
                        .intake = Intake::kState,
                        .help = "triangles of the bowl with their cameras, in force until the next"});
    d.outputs = {{.name = "view", .types = {"bgr8"}, .count = 1, .help = "the picture"}};
    d.parameters = viewpoint_parameters();
    d.parameters.push_back(choice("without_gl", kByCpu, {kByCpu, kStop},
                                  "where there is no OpenGL ES 3: the CPU draws, or the run stops"));
    return d;
  }

  void configure(Configuration& configuration) override {
    name_ = configuration.link_name();
    pixels_ = configuration.pace().pixels;
    check_colours(configuration, kFrames);
    size_px_ = view_size_px(configuration);
    configuration.output(kView, {Format::bgr8(size_px_.x(), size_px_.y())});
    by_gl_.reset();
    by_cpu_.reset();
    gl_name_.clear();
    why_not_gl_.clear();
    read_settings(configuration);
    if (pixels_) begin(configuration);
    mesh_at_ = nullptr;
    inputs_ = {};
    frames_ = frames_by_gl_ = times_lost_ = 0;
  }

  void check(Configuration& configuration) override { read_settings(configuration); }

  void process(Call& call) override {
    if (!pixels_) return call.send(kView, call.create(kView));
    const double time_s = inputs_.take(call, kFrames, kToneMapping);
    Draft view = call.create(kView);
    cv::Mat picture = bgr_picture(view);
    if (!by_gl_ || !painted_by_gl(call, time_s, picture)) paint_by_cpu(call, time_s, picture);
    call.send(kView, std::move(view));
    ++frames_;
  }

  nlohmann::json control(const std::string& command, const nlohmann::json& arguments) override {
    if (command == "viewpoint") return motion_.go_to(arguments);
    throw std::invalid_argument("no command \"" + command + "\", expected viewpoint");
  }

  void stop() override { by_gl_.reset(); }

  void report(nlohmann::json& report) const override {
    if (!pixels_) return;
    nlohmann::json& own = report["bowl_view"];
    own = {{"renderer", gl_name_.empty() ? "cpu" : gl_name_}, {"frames", frames_}, {"by_gl", frames_by_gl_}};
    if (times_lost_ > 0) own["gl_lost"] = times_lost_;
    if (why_not_gl_.empty()) return;
    own["without_gl"] = why_not_gl_;
    report["warnings"].push_back(name_ + ": the CPU draws: " + why_not_gl_);
  }

 private:
  void read_settings(Configuration& configuration) {
    const auto rig = nominal_rig_in_use(configuration);
    if (!rig) return configuration.faults(rig.error());
    vehicle_ = rig->vehicle;
    const bowl::BowlSurface surface = surface_in_use(configuration, vehicle_);
    shape_ = bowl_blend_in_use(configuration);
    motion_.configure(configuration, vehicle_, surface);
    car_ = car_in_use(configuration, vehicle_);
    opacity_ = car_opacity_in_use(configuration);
    may_do_without_gl_ = configuration.parameters().text("without_gl") == kByCpu;
  }

  void begin(Configuration& configuration) {
    try {
      by_gl_.emplace(size_px_);
      gl_name_ = by_gl_->name();
      if (car_) by_gl_->set_car(*car_, vehicle_, opacity_);
    } catch (const std::runtime_error& error) {
      do_without_gl(error.what());
      if (!may_do_without_gl_)
        configuration.parameter_fault("without_gl", why_not_gl_ + "; expected OpenGL ES 3, or \"cpu\" here");
    }
  }

  void do_without_gl(const std::string& why) {
    why_not_gl_ = why;
    by_gl_.reset();
    mesh_at_ = nullptr;
  }

  /// False where OpenGL ES is no more.
  bool painted_by_gl(Call& call, double time_s, cv::Mat& picture) {
    try {
      const Frame& mesh = call.input(kMesh);
      if (is_new(mesh)) {
        const bowl::MeshTable table(mesh.bytes(0));
        by_gl_->set_mesh(table, read_rig_table(mesh.bytes(1)));
        motion_.follow(table.surface());
      }
      by_gl_->paint(inputs_.frames, inputs_.tone_mapping, motion_.at(time_s), colour::bgr_picture(picture));
      times_lost_ = by_gl_->times_lost();
      ++frames_by_gl_;
      return true;
    } catch (const std::runtime_error& error) {  // lost and not to be had again, or refused
      times_lost_ = by_gl_->times_lost();
      if (!may_do_without_gl_) throw;
      do_without_gl(error.what());
      return false;
    }
  }

  void paint_by_cpu(Call& call, double time_s, cv::Mat& picture) {
    if (!by_cpu_) {
      by_cpu_.emplace(size_px_);
      if (car_) by_cpu_->set_car(*car_, vehicle_, opacity_);
    }
    const Frame& mesh = call.input(kMesh);
    if (is_new(mesh)) {
      const bowl::BowlSurface surface = bowl::MeshTable(mesh.bytes(0)).surface();
      by_cpu_->set_world(read_rig_table(mesh.bytes(1)), surface, shape_);
      motion_.follow(surface);
    }
    by_cpu_->paint(inputs_.frames, inputs_.tone_mapping, motion_.at(time_s), picture, call);
  }

  bool is_new(const Frame& mesh) {
    if (mesh.bytes(0).data() == mesh_at_) return false;
    mesh_at_ = mesh.bytes(0).data();
    return true;
  }

  std::string name_;
  bool pixels_ = true;
  Eigen::Vector2i size_px_ = {0, 0};
  geometry::Vehicle vehicle_;
  synthesis::BlendShape shape_;
  ViewpointMotion motion_;
  std::optional<car::CarModel> car_;
  float opacity_ = 1;
  bool may_do_without_gl_ = true;
  std::optional<GlPainter> by_gl_;
  std::optional<BowlPainter> by_cpu_;
  std::string gl_name_, why_not_gl_;
  const std::byte* mesh_at_ = nullptr;
  ViewInputs inputs_;
  uint64_t frames_ = 0, frames_by_gl_ = 0, times_lost_ = 0;
};

}  // namespace

std::unique_ptr<Link> make_bowl_view_gl() {
  return std::make_unique<BowlViewGl>();
}

}  // namespace svchain
