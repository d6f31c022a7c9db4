#pragma once
// Text as it may stand in an SVG file, between tags and in attributes. Plain function, any thread.

#include <string>

namespace svchain {

inline std::string svg_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

}  // namespace svchain
