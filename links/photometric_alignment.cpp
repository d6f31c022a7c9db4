#include "links/photometric_alignment.h"

#include <cstring>
#include <optional>
#include <stdexcept>

#include "algorithms/geometry/rig.h"
#include "algorithms/geometry/view.h"
#include "algorithms/photometric/photometric_alignment.h"
#include "framework/link/call.h"
#include "links/surround_settings.h"

namespace svchain {

namespace {

constexpr int kStatistics = 0;
constexpr int kToneMapping = 0;
constexpr size_t kCameraCount = 4;

class PhotometricAlignmentLink final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "photometric_alignment";
    d.help =
        "matches the cameras' brightness and colour: tone curves for all four jointly, from their overlaps";
    d.inputs = {
        {.name = "statistics", .types = {"overlap_statistics"}, .count = 1, .help = "of the last composite"}};
    d.outputs = {
        {.name = "tone_mapping", .types = {"tone_mapping"}, .count = 1, .help = "for the next composite"}};
    d.parameters = {
        boolean("enabled", true, "false: every camera's values stay as they are"),
        boolean("falloff", true, "undo the cameras' falloff towards the rim where the overlaps show it"),
        number("smoothing", photometric::AlignmentSettings{}.smoothing, {0.001, 1}, "",
               "share of the way to a new estimate that is gone with every frame; 1: at once")};
    return d;
  }

  void configure(Configuration& configuration) override {
    pixels_ = configuration.pace().pixels;
    configuration.output(kToneMapping, {Format::table("tone_mapping", sizeof(synthesis::ToneMapping))});
    const Parameters& given = configuration.parameters();
    enabled_ = given.flag("enabled");
    photometric::AlignmentSettings settings;
    settings.cameras = kCameraCount;
    settings.most_blocks = most_blocks(view_size_px(configuration));
    settings.smoothing = given.number("smoothing");
    settings.falloff = given.flag("falloff");
    alignment_.emplace(settings);
  }

  void process(Call& call) override {
    if (!pixels_) return call.send(kToneMapping, call.create(kToneMapping));
    const auto* statistics =
        reinterpret_cast<const synthesis::OverlapStatistics*>(call.input(kStatistics).bytes().data());
    if (enabled_) alignment_->update(*statistics);
    Draft curves = call.create(kToneMapping);
    std::memcpy(curves.bytes().data(), &in_force(), sizeof(synthesis::ToneMapping));
    call.send(kToneMapping, std::move(curves));
  }

  nlohmann::json control(const std::string& command, const nlohmann::json&) override {
    if (command == "enable" || command == "disable") {
      enabled_ = command == "enable";
    } else if (command != "status") {
      throw std::invalid_argument("no command \"" + command + "\", expected enable, disable or status");
    }
    return status();
  }

  void report(nlohmann::json& report) const override {
    if (pixels_) report["photometric"].update(status());
  }

 private:
  static size_t most_blocks(const Eigen::Vector2i& size_px) {
    geometry::View view;
    view.size_px = size_px;
    return synthesis::OverlapStatistics::bytes_for(view) / sizeof(synthesis::OverlapBlock);
  }

  const synthesis::ToneMapping& in_force() const {
    static const auto identity = synthesis::ToneMapping::identity();
    return enabled_ ? alignment_->tone_mapping() : identity;
  }

  /// Of the last frame.
  nlohmann::json status() const {
    const photometric::Rejections rejections = alignment_->rejections();
    nlohmann::json overlaps = nlohmann::json::object();
    for (const auto& overlap : alignment_->differences()) {
      const std::string name =
          geometry::kCameraNames[overlap.camera_a] + "-" + geometry::kCameraNames[overlap.camera_b];
      overlaps[name] = {{"blocks", overlap.blocks},
                        {"difference_before", overlap.before},
                        {"difference_after", overlap.after}};
    }
    return {{"enabled", enabled_},
            {"frames", alignment_->frames()},
            {"frames_held", alignment_->frames_held()},
            {"blocks",
             {{"used", alignment_->blocks_used()},
              {"rejected",
               {{"small", rejections.small},
                {"dark", rejections.dark},
                {"saturated", rejections.saturated},
                {"contradicting", rejections.contradicting}}}}},
            {"overlaps", overlaps}};
  }

  bool pixels_ = true;
  bool enabled_ = true;
  std::optional<photometric::PhotometricAlignment> alignment_;
};

}  // namespace

std::unique_ptr<Link> make_photometric_alignment() {
  return std::make_unique<PhotometricAlignmentLink>();
}

}  // namespace svchain
