#include "links/display/pixel_hash.h"

#include <array>
#include <cstdio>
#include <openssl/evp.h>
#include <stdexcept>

namespace svchain {

struct PixelHash::Context {
  Context() : evp(EVP_MD_CTX_new()) {}
  ~Context() { EVP_MD_CTX_free(evp); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  EVP_MD_CTX* evp;
};

PixelHash::PixelHash() : context_(std::make_unique<Context>()) {
  if (EVP_DigestInit_ex(context_->evp, EVP_sha256(), nullptr) != 1) throw std::runtime_error("no SHA-256");
}
PixelHash::~PixelHash() = default;
PixelHash::PixelHash(PixelHash&&) noexcept = default;
PixelHash& PixelHash::operator=(PixelHash&&) noexcept = default;

void PixelHash::add(const cv::Mat& bgr) {
  for (int y = 0; y < bgr.rows; ++y) {
    EVP_DigestUpdate(context_->evp, bgr.ptr(y), static_cast<size_t>(bgr.cols) * bgr.elemSize());
  }
}

std::string PixelHash::text() const {
  Context copy;  // so that more may follow
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  EVP_MD_CTX_copy_ex(copy.evp, context_->evp);
  EVP_DigestFinal_ex(copy.evp, digest.data(), &length);
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    char two[3];
    std::snprintf(two, sizeof(two), "%02x", digest[i]);
    text += two;
  }
  return text;
}

}  // namespace svchain
