#include "algorithms/json/document.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <unordered_map>

namespace svchain::json {

struct Document::Content {
  nlohmann::json root;
  std::unordered_map<std::string, Location> places;  // by JSON pointer
};

std::string member_pointer(const std::string& object, std::string_view key) {
  std::string pointer = object + "/";
  for (char c : key) {
    if (c == '~')
      pointer += "~0";
    else if (c == '/')
      pointer += "~1";
    else
      pointer += c;
  }
  return pointer;
}

namespace {

using Json = nlohmann::json;

/// Counts what the parser has taken, so that the builder below knows where it stands.
struct Cursor {
  const char* begin = nullptr;
  const char* at = nullptr;
};

/// A character iterator that tells the cursor how far the parser has come.
struct CountingIterator {
  using difference_type = std::ptrdiff_t;
  using value_type = char;
  using pointer = const char*;
  using reference = const char&;
  using iterator_category = std::input_iterator_tag;
  const char* p;
  Cursor* cursor;
  reference operator*() const { return *p; }
  CountingIterator& operator++() {
    ++p;
    cursor->at = p;
    return *this;
  }
  CountingIterator operator++(int) {
    auto old = *this;
    ++*this;
    return old;
  }
  bool operator==(const CountingIterator& o) const { return p == o.p; }
  bool operator!=(const CountingIterator& o) const { return p != o.p; }
};

class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(const std::string& file, const Cursor& cursor, Document::Content& content)
      : file_(file), cursor_(cursor), content_(content) {}

  Faults faults;

  bool null() override { return scalar(Json(nullptr)); }
  bool boolean(bool v) override { return scalar(Json(v)); }
  bool number_integer(number_integer_t v) override { return scalar(Json(v)); }
  bool number_unsigned(number_unsigned_t v) override { return scalar(Json(v)); }
  bool number_float(number_float_t v, const string_t&) override { return scalar(Json(v)); }
  bool string(string_t& v) override { return scalar(Json(std::move(v))); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& v) override {
    const Location place = next_token();
    Level& level = levels_.back();
    if (level.value->contains(v)) {
      report(place, member_pointer(level.pointer, v), "this key stands twice in its object");
    }
    level.key = v;
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override {
    std::string what = e.what();
    if (auto colon = what.find(": "); colon != std::string::npos) what = what.substr(colon + 2);
    Fault fault{file_, place_of(std::max(cursor_.begin, cursor_.at - 1)), {}, "not valid JSON: " + what};
    faults.push_back(std::move(fault));
    return false;
  }

 private:
  struct Level {
    Json* value;
    std::string pointer;
    std::string key;
  };

  /// Line and column of a character, which must not stand before the one that was asked for last.
  Location place_of(const char* character) {
    for (; scanned_ < character; ++scanned_) {
      if (*scanned_ == '\n') {
        ++line_;
        line_start_ = scanned_ + 1;
      }
    }
    return {line_, static_cast<int>(character - line_start_) + 1};
  }

  /// Where the token begins that the parser has just read. Between it and the token before there is nothing
  /// but blanks and marks, one of which the parser had to take already to see the end of a number.
  Location next_token() {
    constexpr std::string_view kBetweenTokens = " \t\r\n,:]}";
    while (token_ < cursor_.at && kBetweenTokens.find(*token_) != std::string_view::npos) ++token_;
    const Location place = place_of(token_);
    token_ = cursor_.at;
    return place;
  }

  void report(Location place, std::string pointer, std::string message) {
    faults.push_back({file_, place, std::move(pointer), std::move(message)});
  }

  Json* add(Json value) {
    std::string pointer;
    Json* slot = &content_.root;
    if (!levels_.empty()) {
      Level& parent = levels_.back();
      if (parent.value->is_array()) {
        pointer = parent.pointer + "/" + std::to_string(parent.value->size());
        parent.value->push_back(nullptr);
        slot = &parent.value->back();
      } else {
        pointer = member_pointer(parent.pointer, parent.key);
        slot = &(*parent.value)[parent.key];
      }
    }
    *slot = std::move(value);
    content_.places[pointer] = next_token();
    pointer_of_last_ = std::move(pointer);
    return slot;
  }

  bool scalar(Json value) {
    add(std::move(value));
    return true;
  }

  bool open(Json value) {
    if (levels_.size() >= static_cast<size_t>(kDeepest)) {
      report(next_token(), {}, "nested deeper than " + std::to_string(kDeepest) + " levels");
      return false;
    }
    Json* slot = add(std::move(value));
    levels_.push_back({slot, pointer_of_last_, {}});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  const std::string& file_;
  const Cursor& cursor_;
  Document::Content& content_;
  std::vector<Level> levels_;
  std::string pointer_of_last_;
  const char* token_ = cursor_.begin;  // nothing before it belongs to a token not yet seen
  const char* scanned_ = cursor_.begin;
  const char* line_start_ = cursor_.begin;
  int line_ = 1;
};

}  // namespace

Result<std::string> read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  if (!in || std::filesystem::is_directory(path, error))
    return fail(path.string(), "cannot be read, expected a JSON file");
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

Document::Document(std::string file, std::shared_ptr<const Content> content)
    : file_(std::move(file)), content_(std::move(content)) {}

Result<Document> Document::parse(const std::string& text, std::string file) {
  auto content = std::make_shared<Content>();
  const std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const char* first = text.data() + (text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  Cursor cursor{first, first};
  Builder builder(file, cursor, *content);
  const CountingIterator begin{first, &cursor};
  const CountingIterator end{text.data() + text.size(), &cursor};
  const bool parsed = Json::sax_parse(begin, end, &builder);
  if (!parsed && builder.faults.empty()) return fail(std::move(file), "not valid JSON");
  if (!builder.faults.empty()) return tl::unexpected(std::move(builder.faults));
  return Document(std::move(file), std::move(content));
}

Result<Document> Document::read(const std::filesystem::path& path) {
  auto text = read_text(path);
  if (!text) return tl::unexpected(std::move(text.error()));
  return parse(*text, path.string());
}

const nlohmann::json& Document::root() const {
  return content_->root;
}

std::filesystem::path Document::folder() const {
  return std::filesystem::path(file_).parent_path();
}

Location Document::locate(std::string pointer) const {
  while (true) {
    if (auto it = content_->places.find(pointer); it != content_->places.end()) return it->second;
    if (pointer.empty()) return {};
    pointer.erase(pointer.rfind('/'));
  }
}

}  // namespace svchain::json
