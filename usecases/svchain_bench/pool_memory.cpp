#include "usecases/svchain_bench/pool_memory.h"

namespace svchain::bench {

size_t PoolMemory::room_for(size_t bytes) {
  constexpr size_t kPage = 4096;
  return (bytes + kPage - 1) / kPage * kPage;
}

size_t PoolMemory::room_for(const cv::Size& size_px, int type) {
  return room_for(static_cast<size_t>(size_px.area()) * CV_ELEM_SIZE(type));
}

std::span<std::byte> PoolMemory::place(size_t bytes) {
  const std::span<std::byte> placed = region_.bytes().subspan(placed_bytes_, bytes);
  placed_bytes_ += room_for(bytes);
  return placed;
}

cv::Mat PoolMemory::place(const cv::Size& size_px, int type) {
  return {size_px, type, place(static_cast<size_t>(size_px.area()) * CV_ELEM_SIZE(type)).data()};
}

cv::Mat PoolMemory::place_copy(const cv::Mat& picture) {
  cv::Mat placed = place(picture.size(), picture.type());
  picture.copyTo(placed);
  return placed;
}

}  // namespace svchain::bench
