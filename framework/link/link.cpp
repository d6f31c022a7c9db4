#include "framework/link/link.h"

#include <stdexcept>

namespace svchain {

nlohmann::json Link::control(const std::string& command, const nlohmann::json&) {
  throw std::invalid_argument("a link of type \"" + describe().type + "\" knows no command \"" + command +
                              "\"");
}

}  // namespace svchain
