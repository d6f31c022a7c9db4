#include "algorithms/colour/yuv.h"

namespace svchain::colour {

const std::vector<std::string>& yuv_encoding_names() {
  static const std::vector<std::string> kNames = {"bt601_limited", "bt601_full", "bt709_limited",
                                                  "bt709_full"};
  return kNames;
}

std::optional<YuvEncoding> yuv_encoding(std::string_view name) {
  const auto& names = yuv_encoding_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<YuvEncoding>(found - names.begin());
}

}  // namespace svchain::colour
