// An algorithm link from outside: draws the edges of a picture (Sobel, on its green channel) over it.

#include <algorithm>
#include <cstdlib>
#include <framework/link/call.h>
#include <framework/link/link.h>
#include <framework/link/plugin.h>

namespace {

class Edge final : public svchain::Link {
 public:
  svchain::LinkDescription describe() const override {
    svchain::LinkDescription d;
    d.type = "edge";
    d.help = "draws the edges of a picture over it";
    d.inputs = {{.name = "frames", .types = {"bgr8"}, .count = 1}};
    d.outputs = {{.name = "frames", .types = {"bgr8"}, .count = 1}};
    d.parameters = {svchain::number("strength", 0.7, {0, 1}, "", "0: the picture alone, 1: its edges alone")};
    return d;
  }

  void configure(svchain::Configuration& configuration) override {
    configuration.output(0, configuration.input(0));
    edge_share_ = static_cast<int>(configuration.parameters().number("strength") * 256 + 0.5);
    pixels_ = configuration.pace().pixels;
  }

  void process(svchain::Call& call) override {
    const svchain::Frame& in = call.input(0);
    svchain::Draft out = call.create(0);
    if (pixels_) draw(in, out);
    call.send(0, std::move(out));
  }

 private:
  void draw(const svchain::Frame& in, svchain::Draft& out) const {
    const auto* from = reinterpret_cast<const uint8_t*>(in.bytes().data());
    auto* to = reinterpret_cast<uint8_t*>(out.bytes().data());
    const int width = in.format().width_px, height = in.format().height_px, pitch = in.format().pitch_bytes;
    for (int y = 0; y < height; ++y) {
      const int above = std::max(y - 1, 0) * pitch, below = std::min(y + 1, height - 1) * pitch;
      for (int x = 0; x < width; ++x) {
        const int left = std::max(x - 1, 0) * 3 + 1, right = std::min(x + 1, width - 1) * 3 + 1,
                  here = x * 3 + 1;
        const uint8_t *a = from + above, *b = from + below, *c = from + y * pitch;
        const int across = a[right] + 2 * c[right] + b[right] - a[left] - 2 * c[left] - b[left];
        const int down = b[left] + 2 * b[here] + b[right] - a[left] - 2 * a[here] - a[right];
        const int edge = std::min(std::abs(across) + std::abs(down), 255);
        for (int i = y * pitch + x * 3; i < y * pitch + x * 3 + 3; ++i) {
          to[i] = static_cast<uint8_t>((from[i] * (256 - edge_share_) + edge * edge_share_ + 128) / 256);
        }
      }
    }
  }

  int edge_share_ = 0;  // of 256
  bool pixels_ = true;  // false: only the timing counts, nothing is to be read or written
};

}  // namespace

SVCHAIN_PLUGIN(Edge)
