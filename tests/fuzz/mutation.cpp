#include "tests/fuzz/mutation.h"

#include <array>

namespace svchain::testing {

namespace {

const std::array<std::string, 28> kTokens = {"{",
                                             "}",
                                             "[",
                                             "]",
                                             ":",
                                             ",",
                                             "\"",
                                             "\"\"",
                                             "null",
                                             "true",
                                             "-1",
                                             "0",
                                             "1e400",
                                             "-0.0",
                                             "1.",
                                             "NaN",
                                             "123456789012",
                                             "\\u0000",
                                             "\\ud800",
                                             "\xff",
                                             " -> ",
                                             "a.b -> c.d",
                                             "18446744073709551616",
                                             "\"$schema\":1,",
                                             "\"type\"",
                                             "[1,2,3,4]",
                                             "{\"a\":{}}",
                                             "1e-320"};

/// The piece between two marks around a place: roughly a token.
std::pair<size_t, size_t> token_at(const std::string& text, size_t place) {
  const std::string marks = "{}[]:, \n";
  size_t first = place, last = place;
  while (first > 0 && marks.find(text[first - 1]) == std::string::npos) --first;
  while (last < text.size() && marks.find(text[last]) == std::string::npos) ++last;
  return {first, last - first};
}

}  // namespace

uint64_t Mutation::random() {
  uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

std::string Mutation::next(const std::vector<std::string>& texts) {
  std::string text = texts[below(texts.size())];
  for (size_t damages = 1 + below(4); damages > 0 && !text.empty(); --damages) damage(text);
  return text;
}

void Mutation::damage(std::string& text) {
  const size_t place = below(text.size());
  const auto [first, length] = token_at(text, place);
  switch (below(9)) {
    case 0:
      text[place] = static_cast<char>(text[place] ^ (1 << below(8)));
      break;
    case 1:
      text.erase(place, 1 + below(3));
      break;
    case 2:
      text.resize(place);
      break;
    case 3:
      text.insert(place, text.substr(below(text.size()), below(40)));
      break;
    case 4:
      text.insert(place, kTokens[below(kTokens.size())]);
      break;
    case 5:
      text.replace(first, length, kTokens[below(kTokens.size())]);
      break;
    case 6: {
      const auto [other, other_length] = token_at(text, below(text.size()));
      const std::string token = text.substr(other, other_length);
      text.replace(first, length, token);
      break;
    }
    case 7:
      text.erase(first, length);
      break;
    default: {
      const size_t depth = 1 + below(200);
      text.insert(place, std::string(depth, below(2) ? '[' : '{'));
      break;
    }
  }
}

}  // namespace svchain::testing
