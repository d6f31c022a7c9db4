#pragma once
// Strict reading of a document: every getter checks, records a fault with its place on mismatch and returns a
// harmless default, so that one pass finds all faults. A value that is missing stays silent after its first
// fault. Borrows the document and the list of faults; one thread.

#include <initializer_list>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/json/document.h"

namespace svchain::json {

struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  const char* unit = "";  // borrowed; only for messages
  bool contains(double v) const { return v >= minimum && v <= maximum; }
  std::string text() const;  // "0 to 10 ms", "at least 0", "any number"
};

class Value {
 public:
  Value(const Document& document, Faults& faults);

  /// False where an optional value is absent or a required one was missing.
  explicit operator bool() const { return json_ != nullptr; }

  bool is_object() const;
  bool is_array() const;
  bool is_string() const;
  bool is_number() const;

  /// Member of an object: a missing one is a fault (required) or an empty value (optional).
  Value required(std::string_view key) const;
  Value optional(std::string_view key) const;
  /// Faults every member that is none of these ("$schema" is always accepted).
  void only(const std::vector<std::string>& keys) const;
  std::vector<std::pair<std::string, Value>> members() const;
  std::vector<Value> items() const;
  /// An array of exactly this many items, else a fault and an empty list.
  std::vector<Value> items(size_t count) const;

  double number(Range range = {}, double fallback = 0) const;
  long long integer(Range range = {}, long long fallback = 0) const;
  bool boolean(bool fallback = false) const;
  std::string string(std::string fallback = {}) const;
  std::string choice(const std::vector<std::string>& names, std::string fallback = {}) const;
  std::vector<double> numbers(size_t count, Range range = {}) const;

  /// Records a fault at this value. Silent on an absent value.
  void fault(std::string message) const;
  /// Records a fault that was found elsewhere, in a file this document refers to.
  void add_fault(Fault fault) const { faults_->push_back(std::move(fault)); }
  /// Faults recorded so far in the whole reading, so that a reader can tell whether its own part was sound.
  size_t fault_count() const { return faults_->size(); }

  const std::string& pointer() const { return pointer_; }
  const Document& document() const { return *document_; }
  const nlohmann::json& json() const;

 private:
  Value(const Document& document, Faults& faults, const nlohmann::json* json, std::string pointer);
  void expected(std::string_view kind) const;

  const Document* document_;
  Faults* faults_;
  const nlohmann::json* json_;
  std::string pointer_;
};

}  // namespace svchain::json
