#pragma once
// Memory as a chain's pools have it: shared, in huge pages where the system allows them, each piece at a page
// of its own. What is measured beside a chain lies there too. Owns the memory; one thread.

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <span>

#include "ipc/shared_region.h"

namespace svchain::bench {

class PoolMemory {
 public:
  /// Bytes that such a piece takes of it.
  static size_t room_for(size_t bytes);
  static size_t room_for(const cv::Size& size_px, int type);

  PoolMemory() = default;
  /// The sum over room_for() of all pieces to come.
  explicit PoolMemory(size_t bytes) : region_("svchain:bench", bytes) {}

  /// The next piece, which goes with this object.
  std::span<std::byte> place(size_t bytes);
  cv::Mat place(const cv::Size& size_px, int type);
  cv::Mat place_copy(const cv::Mat& picture);

 private:
  ipc::SharedRegion region_;
  size_t placed_bytes_ = 0;
};

}  // namespace svchain::bench
