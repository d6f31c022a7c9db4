#include "links/geometric_alignment/geometric_alignment.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "algorithms/synthesis/lut_file.h"
#include "framework/link/call.h"
#include "links/geometric_alignment/alignment_settings.h"
#include "links/geometric_alignment/charts_alignment.h"
#include "links/geometric_alignment/features_alignment.h"
#include "links/picture_parameters.h"
#include "links/rig_table.h"
#include "links/shown_frame.h"

namespace svchain {

namespace {

constexpr int kFrames = 0;
constexpr int kLut = 0, kRig = 1;
constexpr size_t kCameraCount = 4;

class GeometricAlignment final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "geometric_alignment";
    d.help = "makes the geometric and blending LUT, once, on the first frames, and again when told to";
    d.inputs = {{.name = "frames",
                 .types = {"bgr8", "nv12", "yuyv"},
                 .count = kCameraCount,
                 .help = "sets of four, front right rear left"}};
    d.outputs = {
        {.name = "lut",
         .types = {"geometric_lut"},
         .count = 1,
         .help = "where every output pixel comes from"},
        {.name = "rig", .types = {"rig"}, .count = 1, .help = "the cameras as they have been calibrated"}};
    d.parameters = alignment_parameters();
    return d;
  }

  void configure(Configuration& configuration) override {
    settings_ = read_alignment_settings(configuration);
    check_sizes(configuration);
    check_colours(configuration, kFrames);
    configuration.output(kLut, {Format::table("geometric_lut", lut_capacity())});
    offer_rig(configuration);
    real_times_ = !configuration.pace().virtual_clock;
    pixels_ = configuration.pace().pixels;
    due_ = true;
    luts_ = kept_ = 0;
    accuracy_ = nlohmann::json::object();
    reasons_.clear();
  }

  void check(Configuration& configuration) override { read_alignment_settings(configuration); }

  void process(Call& call) override {
    if (!due_) return;
    const Frame& frames = call.input(kFrames);
    if (luts_ > 0 && !is_complete(frames)) return;  // the next one will do; the first one has to
    Draft lut = call.create(kLut);
    if (pixels_) make(frames, lut.bytes());
    if (reasons_.empty()) {
      call.send(kLut, std::move(lut));
      if (gives_rig_) send_rig(call);
      ++luts_;
    } else if (luts_ == 0) {
      throw std::runtime_error(text_of_reasons());
    } else {
      ++kept_;
    }
    due_ = false;
  }

  nlohmann::json control(const std::string& command, const nlohmann::json&) override {
    if (command == "status") return status();
    if (command != "recalibrate") {
      throw std::invalid_argument("no command \"" + command + "\", expected recalibrate or status");
    }
    if (!settings_.looks_at_frames()) {
      throw std::invalid_argument("source " + settings_.source +
                                  " looks at no frames, expected charts or features");
    }
    due_ = true;
    return {{"recalibrate", "with the next complete set of frames"}, {"source", settings_.source}};
  }

  void report(nlohmann::json& report) const override {
    const geometry::View& view = settings_.view;
    report["view"] = {{"size_px", {view.size_px.x(), view.size_px.y()}},
                      {"metres_per_px", view.metres_per_px},
                      {"centre_m", {view.centre_m.x(), view.centre_m.y()}}};
    report["geometric_alignment"] = status();
    if (luts_ == 0 || !pixels_) return;
    report["lut"] = {{"bytes", footprint_.bytes},
                     {"bytes_per_px", footprint_.bytes_per_pixel},
                     {"source_px", footprint_.source_pixels},
                     {"blocks",
                      {{"empty", footprint_.empty_blocks},
                       {"one_camera", footprint_.one_camera_blocks},
                       {"blend", footprint_.blend_blocks}}}};
  }

 private:
  size_t lut_capacity() const {
    return std::max(settings_.saved.size(), synthesis::geometric_lut_capacity(settings_.view, kCameraCount));
  }

  /// A stored LUT has no poses, and features align the ground alone.
  void offer_rig(Configuration& configuration) {
    gives_rig_ = configuration.output_connected(kRig);
    configuration.output(kRig, {rig_format(settings_.rig)});
    if (gives_rig_ && (settings_.source == "saved" || settings_.source == "features"))
      configuration.parameter_fault("source",
                                    settings_.source +
                                        " gives no poses of the cameras, which the output \"rig\" is "
                                        "for, expected rig, nominal or charts");
  }

  void send_rig(Call& call) {
    Draft rig = call.create(kRig);
    if (pixels_) write_rig(aligned_rig_, rig.bytes());
    call.send(kRig, std::move(rig));
  }

  static bool is_complete(const Frame& frames) {
    for (int c = 0; c < frames.count(); ++c)
      if (!frames.has(c)) return false;
    return true;
  }

  /// Fills the memory and stores it, or leaves the reasons why not.
  void make(const Frame& frames, std::span<std::byte> memory) {
    reasons_.clear();
    try {
      const size_t bytes = settings_.source == "saved" ? copy_saved(memory) : align(frames, memory);
      if (!reasons_.empty()) return;
      const auto footprint = synthesis::GeometricLut(memory).footprint();
      if (!settings_.store.empty()) synthesis::write_lut_file(settings_.store, memory.first(bytes));
      footprint_ = footprint;
    } catch (const std::exception& error) {
      reasons_ = {error.what()};
    }
  }

  size_t copy_saved(std::span<std::byte> memory) const {
    std::memcpy(memory.data(), settings_.saved.data(), settings_.saved.size());
    return settings_.saved.size();
  }

  size_t align(const Frame& frames, std::span<std::byte> memory) {
    GroundAlignment aligned = alignment_of(frames);
    reasons_ = std::move(aligned.reasons);
    aligned_rig_ = aligned.rig;
    accuracy_ = std::move(aligned.accuracy);
    if (!reasons_.empty()) return 0;
    return synthesis::build_geometric_lut(aligned.rig, aligned.rays, settings_.view, settings_.shape, memory);
  }

  GroundAlignment alignment_of(const Frame& frames) const {
    const geometry::Rig& rig = settings_.rig;
    if (!settings_.looks_at_frames()) return {rig, synthesis::rays_from_ground(rig), {}, {}};
    std::array<cv::Mat, kCameraCount> pictures;
    for (size_t c = 0; c < kCameraCount; ++c) {
      pictures[c] = ShownFrame().of(frames, static_cast<int>(c));
      if (pictures[c].empty()) throw std::runtime_error(rig.cameras[c].name + ": no frame in the first set");
    }
    if (settings_.source == "charts") return align_by_charts(settings_, pictures, real_times_);
    if (!settings_.from_content) return align_by_features(rig, pictures, real_times_);
    const GroundAlignment start = align_by_charts(settings_, pictures, real_times_);
    return start.reasons.empty() ? align_by_features(start.rig, pictures, real_times_) : start;
  }

  std::string text_of_reasons() const {
    std::string text = "no LUT from source " + settings_.source;
    const char* separator = ": ";
    for (const std::string& reason : reasons_) {
      text += separator + reason;
      separator = "; ";
    }
    return text;
  }

  /// Of the last alignment there was.
  nlohmann::json status() const {
    nlohmann::json json = accuracy_;
    json["source"] = settings_.source;
    json["accepted"] = reasons_.empty() && luts_ > 0;
    json["luts"] = luts_;
    json["rejected_while_running"] = kept_;
    if (!reasons_.empty()) json["reasons"] = reasons_;
    return json;
  }

  void check_sizes(Configuration& configuration) const {
    const PortFormat& frames = configuration.input(kFrames);
    for (size_t c = 0; c < settings_.rig.cameras.size() && c < frames.size(); ++c) {
      const auto& camera = settings_.rig.cameras[c];
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

  AlignmentSettings settings_;
  geometry::Rig aligned_rig_;  // of the last alignment
  bool gives_rig_ = false;
  bool real_times_ = false;
  bool pixels_ = true;
  bool due_ = true;
  uint64_t luts_ = 0;                             // sent
  uint64_t kept_ = 0;                             // alignments rejected while a LUT was in force
  std::vector<std::string> reasons_;              // why the last alignment was rejected
  nlohmann::json accuracy_;                       // of the last alignment
  synthesis::GeometricLut::Footprint footprint_;  // of the LUT in force
};

}  // namespace

std::unique_ptr<Link> make_geometric_alignment() {
  return std::make_unique<GeometricAlignment>();
}

}  // namespace svchain
