#include "links/rig_table.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace svchain {

Format rig_format(const geometry::Rig& rig) {
  return Format::table("rig", 2 * geometry::rig_text(rig).size() + 4096);
}

void write_rig(const geometry::Rig& rig, std::span<std::byte> into) {
  const std::string text = geometry::rig_text(rig);
  if (text.size() >= into.size())
    throw std::runtime_error("a rig of " + std::to_string(text.size()) + " bytes, room for " +
                             std::to_string(into.size()));
  std::memcpy(into.data(), text.data(), text.size());
  into[text.size()] = std::byte{0};
}

geometry::Rig read_rig_table(std::span<const std::byte> from) {
  const auto* begin = reinterpret_cast<const char*>(from.data());
  const std::string text(begin, std::find(begin, begin + from.size(), '\0'));
  auto rig = geometry::parse_rig(text, "rig");
  if (!rig) throw std::runtime_error(rig.error().front().message);
  return std::move(*rig);
}

}  // namespace svchain
