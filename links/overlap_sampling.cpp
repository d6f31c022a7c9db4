#include "links/overlap_sampling.h"

#include <array>
#include <optional>

#include "algorithms/synthesis/overlap_sampling.h"
#include "framework/link/call.h"
#include "links/image.h"
#include "links/picture_parameters.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kFrames = 0, kLut = 1;
constexpr int kStatistics = 0;
constexpr size_t kCameraCount = 4;

class OverlapSampling final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "overlap_sampling";
    d.help = "takes block means of the overlaps for photometric alignment, where no synthesis does";
    d.inputs = {{.name = "frames",
                 .types = {"bgr8", "nv12", "yuyv"},
                 .count = kCameraCount,
                 .help = "sets of four, front right rear left"},
                {.name = "lut",
                 .types = {"geometric_lut"},
                 .count = 1,
                 .intake = Intake::kState,
                 .help = "where the overlaps are; in force until the next"}};
    d.outputs = {{.name = "statistics",
                  .types = {"overlap_statistics"},
                  .count = 1,
                  .help = "block means of both cameras in every overlap, before tone mapping"}};
    d.parameters = {integer("step", 8, {1, 1600}, "px", "of so many pixels of an overlap one is looked at")};
    return d;
  }

  void configure(Configuration& configuration) override {
    pixels_ = configuration.pace().pixels;
    check_colours(configuration, kFrames);
    geometry::View view;
    view.size_px = view_size_px(configuration);
    configuration.output(
        kStatistics, {Format::table("overlap_statistics", synthesis::OverlapStatistics::bytes_for(view))});
    step_ = static_cast<int>(configuration.parameters().integer("step"));
    lut_.reset();
    lut_at_ = nullptr;
  }

  void process(Call& call) override {
    if (!pixels_) return call.send(kStatistics, call.create(kStatistics));
    const Frame& lut = call.input(kLut);
    if (lut_at_ != lut.bytes().data()) lut_.emplace(lut.bytes());
    lut_at_ = lut.bytes().data();
    std::array<colour::Picture, kCameraCount> frames;
    for (size_t c = 0; c < kCameraCount; ++c)
      frames[c] = any_picture(call.input(kFrames), static_cast<int>(c));
    Draft statistics = call.create(kStatistics);
    auto* overlaps = synthesis::OverlapStatistics::create(statistics.bytes());
    sample_overlaps(*lut_, frames, step_, *overlaps, kernel_);
    call.send(kStatistics, std::move(statistics));
  }

 private:
  const synthesis::Kernel kernel_ = synthesis::best_kernel();
  bool pixels_ = true;
  int step_ = 8;
  std::optional<synthesis::GeometricLut> lut_;
  const std::byte* lut_at_ = nullptr;
};

}  // namespace

std::unique_ptr<Link> make_overlap_sampling() {
  return std::make_unique<OverlapSampling>();
}

}  // namespace svchain
