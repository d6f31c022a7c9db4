#include "links/null_source.h"

#include <array>

#include "framework/link/call.h"
#include "ipc/message.h"
#include "links/pacing.h"

namespace svchain {

namespace {

constexpr std::array kPorts = {0};

/// A grey wedge, another one for every buffer of a set.
void draw(std::span<std::byte> bytes, const Format& format, int buffer) {
  for (int y = 0; y < format.height_px; ++y) {
    const auto row = bytes.subspan(static_cast<size_t>(y) * static_cast<size_t>(format.pitch_bytes));
    for (int x = 0; x < format.width_px * 3; ++x) {
      row[static_cast<size_t>(x)] = static_cast<std::byte>((x / 3 + y + 64 * buffer) & 0xff);
    }
  }
}

class NullSource final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "null_source";
    d.help = "Makes synthetic frames";
    d.outputs = {{.name = "frames", .types = {"bgr8"}, .help = "sets of synthetic pictures"}};
    d.parameters = {
        integer("count", 300, {1, 1e15}, "", "sets to make where the run does not say"),
        integer("width", 1280, {1, 16384}, "px", "width of a picture"),
        integer("height", 720, {1, 16384}, "px", "height of a picture"),
        integer("buffers", 1, {1, ipc::kMaxBuffers}, "", "pictures in a set"),
    };
    return d;
  }

  void configure(Configuration& configuration) override {
    const Parameters& parameters = configuration.parameters();
    const Pace& pace = configuration.pace();
    const auto format = Format::bgr8(static_cast<int>(parameters.integer("width")),
                                     static_cast<int>(parameters.integer("height")));
    pacing_ = Pacing(pace, pace.frames.value_or(static_cast<uint64_t>(parameters.integer("count"))),
                     pace.real_time);
    if (pace.real_time) configuration.calls_without_room();
    pixels_ = pace.pixels;
    buffers_ = static_cast<int>(parameters.integer("buffers"));
    configuration.output(0, PortFormat(static_cast<size_t>(buffers_), format));
    configuration.preloaded(0, 1);
  }

  void process(Call& call) override {
    const auto set = pacing_.due(call, kPorts);
    if (!set) return;
    call.captured();
    if (!pictures_) pictures_ = make_pictures(call);
    if (!pictures_) return call.drop("downstream_full");
    Frame frame = pictures_.share();
    frame.set_sequence(*set);
    frame.set_captured_ns(call.now_ns());
    for (int buffer = 0; buffer < frame.count(); ++buffer)
      frame.set_timestamp_ns(buffer, pacing_.due_ns(*set));
    call.send(0, std::move(frame));
  }

  void stop() override { pictures_.release(); }

 private:
  Frame make_pictures(Call& call) const {
    Draft draft = call.create(0);
    if (!draft) return {};
    for (int buffer = 0; pixels_ && buffer < buffers_; ++buffer)
      draw(draft.bytes(buffer), draft.format(buffer), buffer);
    return std::move(draft).publish();
  }

  Pacing pacing_;
  bool pixels_ = true;
  int buffers_ = 1;
  Frame pictures_;
};

}  // namespace

std::unique_ptr<Link> make_null_source() {
  return std::make_unique<NullSource>();
}

}  // namespace svchain
