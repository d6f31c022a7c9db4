#include "links/capture/capture.h"

#include <algorithm>
#include <array>
#include <vector>

#include "algorithms/colour/convert.h"
#include "algorithms/geometry/rig.h"
#include "framework/link/call.h"
#include "links/capture/frame_source.h"
#include "links/image.h"
#include "links/pacing.h"
#include "links/picture_parameters.h"

namespace svchain {

namespace {

const std::vector<std::string> kTypes = {"bgr8", "nv12", "yuyv"};

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::optional<uint64_t> least(std::optional<uint64_t> a, std::optional<uint64_t> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

class Capture final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "capture";
    d.help = "Takes frames from the four cameras: files, videos, devices, streams or the simulated world";
    for (const std::string& camera : geometry::kCameraNames) {
      d.outputs.push_back(
          {.name = camera, .types = kTypes, .count = 1, .help = "frames of the " + camera + " camera"});
    }
    d.parameters = picture_parameters("", kTypes);
    return d;
  }

  void configure(Configuration& configuration) override {
    const Pace& pace = configuration.pace();
    ports_.clear();
    for (int port = 0; port < static_cast<int>(kCameras); ++port) {
      stills_[static_cast<size_t>(port)].release();
      if (configuration.output_connected(port)) ports_.push_back(port);
    }
    auto opened = open_source(configuration.setting("input").text("value"),
                              {pace.fps, pace.seed, pace.real_time && !pace.virtual_clock, pace.pixels});
    pixels_ = pace.pixels;
    if (!opened) {
      configuration.faults(opened.error());
      return;
    }
    source_ = std::move(*opened);
    const SourceFacts& facts = source_->facts();
    check_rig(configuration, facts);
    const bool real_time = pace.real_time || facts.live;
    if (real_time) configuration.calls_without_room();
    pacing_ = Pacing(pace, least(facts.sets, pace.frames ? pace.frames : facts.usual_sets), real_time);
    set_formats(configuration, facts);
  }

  void start() override { source_->start(); }

  void process(Call& call) override {
    if (source_->ended()) return call.end();
    const auto set = pacing_.due(call, ports_);
    if (!set) return;
    if (source_->facts().still) {
      send_stills(call, *set);
    } else {
      send_set(call, *set);
    }
  }

  void stop() override {
    source_->stop();
    for (Frame& still : stills_) still.release();
  }

 private:
  void set_formats(Configuration& configuration, const SourceFacts& facts) {
    const PictureKind kind = picture_kind(configuration, "");
    for (size_t c = 0; c < kCameras; ++c) {
      const int port = static_cast<int>(c);
      const cv::Size size = facts.size_px[c];
      const std::string what = "the picture of camera \"" + geometry::kCameraNames[c] + "\"";
      configuration.output(port, {picture_format(configuration, "", kind, size.width, size.height, what)});
      seen_[c] = kind.type == "bgr8" ? cv::Mat() : cv::Mat(size, CV_8UC3);
      if (facts.still) configuration.preloaded(port, 1);
    }
  }

  static void check_rig(Configuration& configuration, const SourceFacts& facts) {
    const std::string path = configuration.setting("rig").text("value");
    if (path.empty()) return;
    const auto rig = geometry::read_rig(path);
    if (!rig) return configuration.faults(rig.error());
    for (size_t c = 0; c < kCameras; ++c) {
      const Eigen::Vector2i expected = rig->cameras[c].image_size_px;
      const cv::Size got = facts.size_px[c];
      if (got.width == expected.x() && got.height == expected.y()) continue;
      configuration.fault("input: images of camera \"" + geometry::kCameraNames[c] + "\" are " +
                          size_text(got.width, got.height) + " px, the rig " + path + " expects " +
                          size_text(expected.x(), expected.y()));
    }
  }

  /// The same buffers again and again, as a camera hands out what it has in memory already.
  void send_stills(Call& call, uint64_t set) {
    call.captured();
    for (const int port : ports_) {
      Frame& still = stills_[static_cast<size_t>(port)];
      if (!still) {
        Draft draft = call.create(port);
        if (!draft) return call.drop("downstream_full");
        read(draft, set, port);
        still = std::move(draft).publish();
      }
      Frame frame = still.share();
      frame.set_sequence(set);
      frame.set_captured_ns(call.now_ns());
      frame.set_timestamp_ns(0, pacing_.due_ns(set));
      call.send(port, std::move(frame));
    }
  }

  /// All four are read before the first is sent: a camera's error leaves no half set behind.
  void send_set(Call& call, uint64_t set) {
    std::array<Draft, kCameras> drafts;
    for (const int port : ports_) {
      drafts[static_cast<size_t>(port)] = call.create(port);
      if (drafts[static_cast<size_t>(port)]) continue;
      call.captured();
      return call.drop("downstream_full");
    }
    const bool certain = source_->facts().usual_sets.has_value();
    if (certain) call.captured();  // it is there, even if reading it fails
    bool any = false;
    bool all = true;
    for (const int port : ports_) {
      Draft& draft = drafts[static_cast<size_t>(port)];
      const auto time_ns = read(draft, set, port);
      if (!time_ns) {
        draft = Draft();
        all = false;
        continue;
      }
      draft.set_sequence(set);
      draft.set_captured_ns(call.now_ns());
      draft.set_timestamp_ns(*time_ns);
      any = true;
    }
    if (!any || (!all && !source_->facts().live)) return;  // came to its end
    if (!certain) call.captured();
    for (const int port : ports_) {
      if (Draft& draft = drafts[static_cast<size_t>(port)]) call.send(port, std::move(draft));
    }
  }

  /// Sources give BGR. Other formats are made of it here, as a camera's image processor does.
  std::optional<int64_t> read(Draft& draft, uint64_t set, int port) {
    const auto camera = static_cast<size_t>(port);
    if (!pixels_) return source_->time_ns(set, camera);
    cv::Mat& seen = seen_[camera];
    if (seen.empty()) {
      cv::Mat image = bgr_picture(draft);
      return source_->read(set, camera, image);
    }
    const auto time_ns = source_->read(set, camera, seen);
    if (time_ns) colour::yuv_from_bgr(colour::bgr_picture(seen), any_picture(draft));
    return time_ns;
  }

  bool pixels_ = true;
  std::unique_ptr<FrameSource> source_;
  Pacing pacing_;
  std::vector<int> ports_;  // connected ones
  std::array<Frame, kCameras> stills_;
  // In BGR, for other formats to be made of; empty where BGR is asked for.
  std::array<cv::Mat, kCameras> seen_;
};

}  // namespace

std::unique_ptr<Link> make_capture() {
  return std::make_unique<Capture>();
}

}  // namespace svchain
