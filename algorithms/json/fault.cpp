#include "algorithms/json/fault.h"

#include <algorithm>
#include <cctype>

namespace svchain {

std::string Fault::text() const {
  std::string line = file;
  if (where.line > 0) line += ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
  if (!line.empty()) line += ": ";
  line += "error: ";
  if (!pointer.empty()) line += pointer + ": ";
  return line + message;
}

tl::unexpected<Faults> fail(std::string file, std::string message) {
  return tl::unexpected(Faults{Fault{std::move(file), {}, {}, std::move(message)}});
}

std::string spoken_list(const std::vector<std::string>& names) {
  std::string list;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += names[i];
  }
  return list;
}

namespace {

/// Letters to insert, delete, change or swap with their neighbour (optimal string alignment), whatever their
/// case.
size_t edit_distance(const std::string& a, const std::string& b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& given, const std::vector<std::string>& names) {
  constexpr size_t kLongestName = 64;  // a longer word is no slip of the pen, and the distance is quadratic
  if (given.size() > kLongestName) return {};
  std::string nearest;
  size_t best = std::max<size_t>(1, given.size() / 3) + 1;
  for (const auto& name : names) {
    const bool prefix = given.size() >= 3 && name.compare(0, given.size(), given) == 0;
    const size_t distance = prefix ? 1 : edit_distance(given, name);
    if (distance < best) {
      best = distance;
      nearest = name;
    }
  }
  return nearest.empty() ? "" : ", did you mean \"" + nearest + "\"?";
}

}  // namespace svchain
