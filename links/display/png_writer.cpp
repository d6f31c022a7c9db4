#include "links/display/png_writer.h"

#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "links/display/temporary_file.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

/// Encoded first and written then, so that a full disk is noticed.
void write_png(const fs::path& file, const cv::Mat& picture, std::vector<uchar>& encoded) {
  TemporaryFile temporary(file);
  cv::imencode(".png", picture, encoded);
  std::ofstream stream(temporary.path(), std::ios::binary);
  stream.write(reinterpret_cast<const char*>(encoded.data()), static_cast<std::streamsize>(encoded.size()));
  stream.close();
  if (!stream) throw std::runtime_error(file.string() + " cannot be written");
  temporary.keep();
}

class LastFrameWriter final : public FrameWriter {
 public:
  explicit LastFrameWriter(fs::path file) : file_(std::move(file)) {}
  int holds() const override { return 1; }
  void write(Frame&& frame, ShownFrame&) override { last_ = std::move(frame); }
  void finish() override {
    if (!last_) return;
    std::vector<uchar> encoded;
    write_png(file_, ShownFrame().of(last_), encoded);
    last_.release();
  }

 private:
  fs::path file_;
  Frame last_;
};

class FolderWriter final : public FrameWriter {
 public:
  explicit FolderWriter(fs::path folder) : folder_(std::move(folder)) {}

  void write(Frame&& frame, ShownFrame& shown) override {
    if (count_ == 0) make_folder();
    char name[32];
    std::snprintf(name, sizeof(name), "%06llu.png", static_cast<unsigned long long>(count_++));
    write_png(folder_ / name, shown.of(frame), encoded_);
  }

 private:
  void make_folder() {
    std::error_code failed;
    fs::create_directory(folder_, failed);
    if (failed) throw std::runtime_error(folder_.string() + " cannot be made: " + failed.message());
  }

  fs::path folder_;
  uint64_t count_ = 0;
  std::vector<uchar> encoded_;
};

}  // namespace

std::unique_ptr<FrameWriter> make_last_frame_writer(const fs::path& file) {
  return std::make_unique<LastFrameWriter>(file);
}

std::unique_ptr<FrameWriter> make_folder_writer(const fs::path& folder) {
  return std::make_unique<FolderWriter>(folder);
}

}  // namespace svchain
