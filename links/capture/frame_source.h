#pragma once
// Where the four cameras' frames come from. Cameras are numbered as they are named: front, right, rear, left.
//
// Thread rule: made on the caller's thread; from start() to stop() only the capture's core calls it. One
// source feeds one capture. Errors: what can be found beforehand is in open_source's faults; read() throws
// std::runtime_error that names camera, frame and file.

#include <array>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "algorithms/json/fault.h"

namespace svchain {

constexpr size_t kCameras = 4;

struct SourceFacts {
  std::array<cv::Size, kCameras> size_px;
  std::optional<uint64_t> sets;        // how many sets of four there are; nothing: without end
  std::optional<uint64_t> usual_sets;  // how many are taken where nobody says; nothing: until stopped
  bool live = false;                   // frames come when they come, and wait for nobody
  bool still = false;                  // every set is the same
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual const SourceFacts& facts() const = 0;

  virtual void start() {}
  /// Writes a camera's frame of a set into the picture (BGR8 of the camera's size, memory of the caller) and
  /// returns its time stamp in ns from the first set; nothing where the camera has no frame for it. Sets are
  /// asked for in rising order, not necessarily all of them.
  virtual std::optional<int64_t> read(uint64_t set, size_t camera, cv::Mat& into) = 0;
  /// The time stamp alone, of a frame that is there.
  virtual int64_t time_ns(uint64_t set, size_t camera) const = 0;
  /// Nothing will come any more, although `sets` did not say so.
  virtual bool ended() const { return false; }
  virtual void stop() {}
};

struct SourceRequest {
  double fps = 30;         // nominal rate of the time stamps
  uint64_t seed = 1;       // of simulated noise
  bool real_time = false;  // frames must be there when they are due
  bool pixels = true;      // false: only time_ns() will be called, not read()
};

/// SOURCE as on the command line: a directory, `simulated:SCENE` or `front=URL,right=URL,rear=URL,left=URL`.
Result<std::unique_ptr<FrameSource>> open_source(const std::string& source, const SourceRequest& request);

/// Frames come when they come: the run is in real time without being told.
bool is_live_source(const std::string& source);
/// The source's own rate, where it has one (videos, scenes). Says nothing of sources that cannot be opened.
std::optional<double> source_fps(const std::string& source);

/// The nominal time stamp of a set.
int64_t nominal_time_ns(uint64_t set, double fps);

}  // namespace svchain
