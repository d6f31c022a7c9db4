#include "links/display/video_writer.h"

#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "links/display/temporary_file.h"
#include "links/quiet_opencv.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

class VideoWriter final : public FrameWriter {
 public:
  VideoWriter(const fs::path& file, const WriterRequest& request)
      : temporary_(file), fps_(request.fps), size_(request.format.width_px, request.format.height_px) {}

  bool open() {
    const bool lossless = temporary_.target().extension() == ".mkv";
    const int codec =
        lossless ? cv::VideoWriter::fourcc('F', 'F', 'V', '1') : cv::VideoWriter::fourcc('a', 'v', 'c', '1');
    return writer_.open(temporary_.path().string(), cv::CAP_FFMPEG, codec, fps_, size_);
  }
  void discard() {
    writer_.release();
    temporary_.remove();
  }

  void write(Frame&& frame, ShownFrame& shown) override {
    if (!writer_.isOpened() && !open()) {
      throw std::runtime_error(temporary_.target().string() + " cannot be opened for writing");
    }
    writer_.write(shown.of(frame));
    ++count_;
  }

  void finish() override {
    if (count_ == 0) return;
    writer_.release();
    std::error_code failed;
    if (fs::file_size(temporary_.path(), failed) == 0 || failed) {
      throw std::runtime_error(temporary_.target().string() + " could not be written");
    }
    temporary_.keep();
  }

  ~VideoWriter() override { writer_.release(); }

 private:
  TemporaryFile temporary_;
  double fps_;
  cv::Size size_;
  cv::VideoWriter writer_;
  uint64_t count_ = 0;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> make_video_writer(const fs::path& file, const WriterRequest& request) {
  const Format& format = request.format;
  if (format.width_px % 2 != 0 || format.height_px % 2 != 0) {
    return fail(file.string(), "a video needs an even width and height, the view is " +
                                   std::to_string(format.width_px) + "x" + std::to_string(format.height_px) +
                                   " px; a directory or .png takes any");
  }
  quiet_opencv();
  auto writer = std::make_unique<VideoWriter>(file, request);
  const bool can = writer->open();
  writer->discard();
  if (!can)
    return fail(file.string(), "no encoder for " + file.extension().string() + " videos could be opened");
  return writer;
}

}  // namespace svchain
