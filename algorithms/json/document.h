#pragma once
// A JSON text with the line and column of every value in it. Strict: no duplicate keys, no NaN, no comments,
// nesting at most kDeepest. Owns its values; immutable after parsing, so any thread may read it.

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "algorithms/json/fault.h"

namespace svchain::json {

constexpr int kDeepest = 64;

/// A whole text file.
Result<std::string> read_text(const std::filesystem::path& path);

/// JSON pointer of an object's member, "~" and "/" in its key escaped.
std::string member_pointer(const std::string& object, std::string_view key);

class Document {
 public:
  /// Faults of syntax carry line and column. `file` is what messages call the text.
  static Result<Document> parse(const std::string& text, std::string file);
  static Result<Document> read(const std::filesystem::path& path);

  const nlohmann::json& root() const;
  const std::string& file() const { return file_; }
  /// Folder that relative file names inside the document refer to.
  std::filesystem::path folder() const;
  /// Place of the value at a JSON pointer; of its nearest known parent where it does not exist.
  Location locate(std::string pointer) const;

  struct Content;

 private:
  Document(std::string file, std::shared_ptr<const Content> content);
  std::string file_;
  std::shared_ptr<const Content> content_;
};

}  // namespace svchain::json
