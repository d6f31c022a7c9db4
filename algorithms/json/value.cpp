#include "algorithms/json/value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace svchain::json {

namespace {

std::string shown(const nlohmann::json& json) {
  constexpr size_t kLongest = 40;
  if (json.is_object()) return "an object";
  if (json.is_array()) return "an array of " + std::to_string(json.size());
  std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

std::string plain(double v) {
  std::ostringstream out;
  out << v;
  return out.str();
}

}  // namespace

std::string Range::text() const {
  const bool low = std::isfinite(minimum);
  const bool high = std::isfinite(maximum);
  const std::string suffix = *unit ? " " + std::string(unit) : "";
  if (low && high) return plain(minimum) + " to " + plain(maximum) + suffix;
  if (low) return "at least " + plain(minimum) + suffix;
  if (high) return "at most " + plain(maximum) + suffix;
  return "any number";
}

Value::Value(const Document& document, Faults& faults) : Value(document, faults, &document.root(), {}) {}

Value::Value(const Document& document, Faults& faults, const nlohmann::json* json, std::string pointer)
    : document_(&document), faults_(&faults), json_(json), pointer_(std::move(pointer)) {}

bool Value::is_object() const {
  return json_ && json_->is_object();
}
bool Value::is_array() const {
  return json_ && json_->is_array();
}
bool Value::is_string() const {
  return json_ && json_->is_string();
}
bool Value::is_number() const {
  return json_ && json_->is_number();
}

void Value::fault(std::string message) const {
  if (!json_) return;
  const bool known = std::any_of(faults_->begin(), faults_->end(), [&](const Fault& fault) {
    return fault.pointer == pointer_ && fault.message == message && fault.file == document_->file();
  });
  if (known) return;  // every getter of a value at fault finds the same
  faults_->push_back({document_->file(), document_->locate(pointer_), pointer_, std::move(message)});
}

void Value::expected(std::string_view kind) const {
  if (json_) fault("expected " + std::string(kind) + ", got " + shown(*json_));
}

Value Value::required(std::string_view key) const {
  Value found = optional(key);
  if (!found && is_object()) fault("\"" + std::string(key) + "\" is missing");
  return found;
}

Value Value::optional(std::string_view key) const {
  const nlohmann::json* found = nullptr;
  if (json_ && !json_->is_object()) expected("an object");
  if (is_object()) {
    if (auto it = json_->find(std::string(key)); it != json_->end()) found = &*it;
  }
  return Value(*document_, *faults_, found, member_pointer(pointer_, key));
}

void Value::only(const std::vector<std::string>& keys) const {
  if (json_ && !json_->is_object()) return expected("an object");
  for (const auto& [key, member] : members()) {
    if (key == "$schema" || std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    member.fault("unknown key" + did_you_mean(key, keys) + " (known: " + spoken_list(keys) + ")");
  }
}

std::vector<std::pair<std::string, Value>> Value::members() const {
  std::vector<std::pair<std::string, Value>> list;
  if (!json_) return list;
  if (!json_->is_object()) {
    expected("an object");
    return list;
  }
  for (const auto& [key, member] : json_->items()) {
    list.emplace_back(key, Value(*document_, *faults_, &member, member_pointer(pointer_, key)));
  }
  return list;
}

std::vector<Value> Value::items() const {
  std::vector<Value> list;
  if (!json_) return list;
  if (!json_->is_array()) {
    expected("an array");
    return list;
  }
  for (size_t i = 0; i < json_->size(); ++i) {
    list.push_back(Value(*document_, *faults_, &(*json_)[i], member_pointer(pointer_, std::to_string(i))));
  }
  return list;
}

std::vector<Value> Value::items(size_t count) const {
  if (json_ && (!json_->is_array() || json_->size() != count)) {
    expected("an array of " + std::to_string(count));
    return {};
  }
  return items();
}

double Value::number(Range range, double fallback) const {
  if (!json_) return fallback;
  if (!json_->is_number()) {
    expected("a number");
    return fallback;
  }
  const double v = json_->get<double>();
  if (!std::isfinite(v) || !range.contains(v)) {
    expected(range.text());
    return fallback;
  }
  return v;
}

long long Value::integer(Range range, long long fallback) const {
  if (!json_) return fallback;
  const bool whole =
      json_->is_number_integer() || (json_->is_number_float() && std::abs(json_->get<double>()) < 9e15 &&
                                     std::floor(json_->get<double>()) == json_->get<double>());
  const bool fits = !json_->is_number_unsigned() || json_->get<unsigned long long>() <= (1ull << 62);
  if (!whole || !fits) {
    expected("a whole number");
    return fallback;
  }
  const long long v =
      json_->is_number_float() ? static_cast<long long>(json_->get<double>()) : json_->get<long long>();
  if (!range.contains(static_cast<double>(v))) {
    expected(range.text());
    return fallback;
  }
  return v;
}

bool Value::boolean(bool fallback) const {
  if (!json_) return fallback;
  if (!json_->is_boolean()) {
    expected("true or false");
    return fallback;
  }
  return json_->get<bool>();
}

std::string Value::string(std::string fallback) const {
  if (!json_) return fallback;
  if (!json_->is_string()) {
    expected("a string");
    return fallback;
  }
  return json_->get<std::string>();
}

std::string Value::choice(const std::vector<std::string>& names, std::string fallback) const {
  if (!json_) return fallback;
  if (!json_->is_string()) {
    expected(spoken_list(names));
    return fallback;
  }
  const auto name = json_->get<std::string>();
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  fault("expected " + spoken_list(names) + ", got " + shown(*json_) + did_you_mean(name, names));
  return fallback;
}

std::vector<double> Value::numbers(size_t count, Range range) const {
  std::vector<double> list;
  for (const auto& item : items(count)) list.push_back(item.number(range));
  list.resize(count, 0.0);
  return list;
}

const nlohmann::json& Value::json() const {
  static const nlohmann::json kAbsent;
  return json_ ? *json_ : kAbsent;
}

}  // namespace svchain::json
