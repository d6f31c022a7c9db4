#include "links/synthesis.h"

#include <array>
#include <cstring>
#include <optional>

#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/synthesize.h"
#include "framework/link/call.h"
#include "links/image.h"
#include "links/picture_parameters.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kFrames = 0, kLut = 1, kToneMapping = 2;
constexpr int kView = 0, kStatistics = 1;
constexpr size_t kCameraCount = 4;
constexpr int kPartsPerCpu = 4;  // blocks differ in cost
constexpr const char* kAuto = "auto";
const std::vector<std::string> kViewTypes = {"bgr8", "bgrx8", "nv12"};

class Synthesis final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "synthesis";
    d.help = "makes the composite from a set of four through the LUTs, and block means of the overlaps";
    d.inputs = {{.name = "frames",
                 .types = {"bgr8", "nv12", "yuyv"},
                 .count = kCameraCount,
                 .help = "sets of four, front right rear left"},
                {.name = "lut",
                 .types = {"geometric_lut"},
                 .count = 1,
                 .intake = Intake::kState,
                 .help = "in force until the next"},
                {.name = "tone_mapping",
                 .types = {"tone_mapping"},
                 .count = 1,
                 .optional = true,
                 .help = "applied to the next frame; the identity before the first"}};
    d.outputs = {{.name = "view", .types = kViewTypes, .count = 1, .help = "the composite"},
                 {.name = "statistics",
                  .types = {"overlap_statistics"},
                  .count = 1,
                  .help = "block means of both cameras in every overlap, before tone mapping"}};
    d.parameters = picture_parameters("output_", kViewTypes);
    std::vector<std::string> kernels = {kAuto};
    kernels.insert(kernels.end(), synthesis::kernel_names().begin(), synthesis::kernel_names().end());
    d.parameters.push_back(choice("kernel", kAuto, kernels,
                                  "instructions it runs on; auto: the fastest that the processor has"));
    return d;
  }

  void configure(Configuration& configuration) override {
    pixels_ = configuration.pace().pixels;
    check_colours(configuration, kFrames);
    geometry::View view;
    view.size_px = view_size_px(configuration);
    const PictureKind kind = picture_kind(configuration, "output_");
    configuration.output(kView, {picture_format(configuration, "output_", kind, view.size_px.x(),
                                                view.size_px.y(), "the view")});
    configuration.output(
        kStatistics, {Format::table("overlap_statistics", synthesis::OverlapStatistics::bytes_for(view))});
    choose_kernel(configuration);
    tone_mapping_ = synthesis::ToneMapping::identity();
    lut_.reset();
    lut_at_ = nullptr;
  }

  void process(Call& call) override {
    if (!pixels_) {
      call.send(kView, call.create(kView));
      return call.send(kStatistics, call.create(kStatistics));
    }
    if (const Frame& curves = call.input(kToneMapping)) {
      std::memcpy(&tone_mapping_, curves.bytes().data(), sizeof(tone_mapping_));
    }
    std::array<colour::Picture, kCameraCount> frames;
    for (size_t c = 0; c < kCameraCount; ++c)
      frames[c] = any_picture(call.input(kFrames), static_cast<int>(c));
    Draft view = call.create(kView);
    Draft statistics = call.create(kStatistics);
    const synthesis::GeometricLut& lut = lut_of(call.input(kLut));
    auto* overlaps = synthesis::OverlapStatistics::create(statistics.bytes());
    overlaps->expect(lut.header().overlap_count);
    const colour::Picture composite = any_picture(view);
    const int parts = call.cpus() > 1 ? call.cpus() * kPartsPerCpu : 1;
    const auto part = [&](int i) {
      synthesis::synthesize_part({i, parts}, lut, frames, tone_mapping_, composite, overlaps, kernel_);
    };
    call.parallel(parts, part);
    call.send(kView, std::move(view));
    call.send(kStatistics, std::move(statistics));
  }

  void report(nlohmann::json& report) const override {
    report["synthesis"]["kernel"] = synthesis::name_of(kernel_);
    if (!pixels_) return;
    for (size_t c = 0; c < kCameraCount; ++c) {
      auto& camera = report["photometric"]["tone_mapping"][geometry::kCameraNames[c]];
      camera = {{"b", tone_mapping_.curves[c][0]},
                {"g", tone_mapping_.curves[c][1]},
                {"r", tone_mapping_.curves[c][2]}};
      const auto [a1, a2] = tone_mapping_.falloff[c];
      report["photometric"]["falloff"][geometry::kCameraNames[c]] = {double(a1) / synthesis::kRadialOne,
                                                                     double(a2) / synthesis::kRadialOne};
    }
  }

 private:
  void choose_kernel(Configuration& configuration) {
    const std::string name = configuration.parameters().text("kernel");
    kernel_ = synthesis::best_kernel();
    if (name == kAuto) return;
    const auto kernel = synthesis::kernel_named(name);
    if (kernel)
      kernel_ = *kernel;
    else
      configuration.parameter_fault("kernel", kernel.error().front().message);
  }

  /// A LUT is checked when it is new. The one in force is held, so a new one lies elsewhere.
  const synthesis::GeometricLut& lut_of(const Frame& frame) {
    if (lut_at_ != frame.bytes().data()) lut_.emplace(frame.bytes());
    lut_at_ = frame.bytes().data();
    return *lut_;
  }

  bool pixels_ = true;
  synthesis::Kernel kernel_ = synthesis::Kernel::kPortable;
  std::optional<synthesis::GeometricLut> lut_;
  const std::byte* lut_at_ = nullptr;
  synthesis::ToneMapping tone_mapping_;  // what the last frame was made with
};

}  // namespace

std::unique_ptr<Link> make_synthesis() {
  return std::make_unique<Synthesis>();
}

}  // namespace svchain
