#pragma once
// Where delivered frames go, as BGR whatever they are: a picture, a video, a folder of pictures, a window.
// Nothing half-written is ever to be seen: files are written under another name in the same folder and get
// theirs in finish(); without it, or with no frame, nothing is left. Belongs to the display's core. write()
// and finish() throw std::runtime_error that names the file.

#include <filesystem>
#include <memory>
#include <string>

#include "algorithms/json/fault.h"
#include "framework/buffer/frame.h"
#include "links/shown_frame.h"

namespace svchain {

class FrameWriter {
 public:
  virtual ~FrameWriter() = default;
  /// Frames that it keeps beyond a call of write().
  virtual int holds() const { return 0; }
  /// `shown` gives the picture, to those who want it now.
  virtual void write(Frame&& frame, ShownFrame& shown) = 0;
  virtual void finish() {}
};

struct WriterRequest {
  Format format;
  double fps = 30;
};

/// PATH as on the command line: `.png`, `.mp4`, `.mkv`, a directory, `window` or `none` (then the writer is
/// null). What cannot be written is found here.
Result<std::unique_ptr<FrameWriter>> make_writer(const std::string& output, const WriterRequest& request);

}  // namespace svchain
