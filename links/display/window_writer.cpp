#include "links/display/window_writer.h"

#include <cstdlib>
#include <opencv2/highgui.hpp>

namespace svchain {

namespace {

constexpr const char* kTitle = "svchain";

class WindowWriter final : public FrameWriter {
 public:
  void write(Frame&& frame, ShownFrame& picture) override {
    cv::imshow(kTitle, picture.of(frame));
    cv::waitKey(1);  // lets the window draw itself
    shown_ = true;
  }
  void finish() override {
    if (shown_) cv::destroyWindow(kTitle);
  }

 private:
  bool shown_ = false;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> make_window_writer() {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) {
    return fail("window", "there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set");
  }
  return std::make_unique<WindowWriter>();
}

}  // namespace svchain
