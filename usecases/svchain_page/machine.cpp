#include "usecases/svchain_page/machine.h"

#include <ctime>
#include <fstream>
#include <opencv2/core/version.hpp>

namespace svchain::page {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string compiler() {
  return "g++ " __VERSION__;
}

std::string opencv_version() {
  return CV_VERSION;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace svchain::page
