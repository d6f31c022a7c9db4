#include "links/mosaic.h"

#include <algorithm>
#include <array>
#include <opencv2/core/mat.hpp>

#include "framework/link/call.h"
#include "links/image.h"

namespace svchain {

namespace {

constexpr std::array<const char*, 2> kInputs = {"left", "right"};
constexpr int kPicture = 0;

class Mosaic final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "mosaic";
    d.help = "puts two pictures side by side; the lower one is centred, black above and below it";
    for (const char* name : kInputs)
      d.inputs.push_back({.name = name, .types = {"bgr8"}, .count = 1, .help = "a picture"});
    d.outputs = {{.name = "picture", .types = {"bgr8"}, .count = 1, .help = "both"}};
    return d;
  }

  void configure(Configuration& configuration) override {
    pixels_ = configuration.pace().pixels;
    int width_px = 0, height_px = 0;
    for (size_t i = 0; i < kInputs.size(); ++i) {
      const Format& format = configuration.input(static_cast<int>(i)).front();
      width_px += format.width_px;
      height_px = std::max(height_px, format.height_px);
    }
    configuration.output(kPicture, {Format::bgr8(width_px, height_px)});
  }

  void process(Call& call) override {
    if (!pixels_) return call.send(kPicture, call.create(kPicture));
    Draft draft = call.create(kPicture);
    cv::Mat picture = bgr_picture(draft);
    int x = 0;
    for (size_t i = 0; i < kInputs.size(); ++i) {
      const cv::Mat part = bgr_picture(call.input(static_cast<int>(i)));
      cv::Mat column = picture.colRange(x, x + part.cols);
      const int above = (picture.rows - part.rows) / 2;
      column.rowRange(0, above).setTo(0);
      part.copyTo(column.rowRange(above, above + part.rows));
      column.rowRange(above + part.rows, picture.rows).setTo(0);
      x += part.cols;
    }
    call.send(kPicture, std::move(draft));
  }

 private:
  bool pixels_ = true;
};

}  // namespace

std::unique_ptr<Link> make_mosaic() {
  return std::make_unique<Mosaic>();
}

}  // namespace svchain
