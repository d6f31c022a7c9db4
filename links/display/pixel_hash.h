#pragma once
// SHA-256 over the pixels of pictures, one after the other, rows without padding. Moves only; one thread.

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

namespace svchain {

class PixelHash {
 public:
  /// Throws std::runtime_error where there is no SHA-256.
  PixelHash();
  ~PixelHash();
  PixelHash(PixelHash&&) noexcept;
  PixelHash& operator=(PixelHash&&) noexcept;

  void add(const cv::Mat& bgr);
  /// 64 hexadecimal digits; of all so far.
  std::string text() const;

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace svchain
