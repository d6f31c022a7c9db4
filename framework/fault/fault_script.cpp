#include "framework/fault/fault_script.h"

#include <algorithm>

#include "framework/usecase/place.h"

namespace svchain {

namespace {

using json::Document;
using json::Range;
using json::Value;

constexpr Range kTime = {0, 1e6, "s"};
constexpr Range kLasting = {0.001, 1e6, "s"};
constexpr Range kPerHour = {0.001, 3600, "faults an hour"};
constexpr Range kChance = {0, 1};
constexpr Range kJitter = {0, 1000, "ms"};
constexpr Range kDelay = {0, 60'000, "ms"};
constexpr Range kOffset = {-1e8, 1e8, "ms"};
constexpr Range kFactor = {1, 1000};

/// What an entry says besides "kind", "at" and its times.
struct KindKeys {
  bool chance;
  const char* amount = nullptr;
  Range range = {};
};
constexpr KindKeys kKindKeys[] = {{true},                        // dropout
                                  {false},                       // freeze
                                  {true, "jitter_ms", kJitter},  // jitter
                                  {true, "shift_ms", kOffset},   // wrong_timestamp
                                  {true},                        // corrupt
                                  {false, "extra_ms", kDelay},   // slow
                                  {true},                        // throw
                                  {false},                       // no_memory
                                  {true},                        // lost
                                  {true, "late_ms", kDelay},     // late
                                  {false},                       // full
                                  {false},                       // halt
                                  {false, "step_ms", kOffset}};  // clock_step
static_assert(std::size(kKindKeys) == kFaultKinds);

const KindKeys& keys_for(FaultKind kind) {
  return kKindKeys[static_cast<size_t>(kind)];
}

std::vector<std::string> key_names(FaultKind kind) {
  std::vector<std::string> names = {"kind", "from_s", "to_s"};
  if (kind != FaultKind::kClockStep) names.insert(names.begin() + 1, "at");
  if (keys_for(kind).chance) names.emplace_back("chance");
  if (keys_for(kind).amount) names.emplace_back(keys_for(kind).amount);
  if (kind == FaultKind::kSlow) names.emplace_back("factor");
  return names;
}

const std::vector<std::string> kEveryKey = {"kind",    "at",        "from_s",   "to_s",
                                            "chance",  "jitter_ms", "shift_ms", "extra_ms",
                                            "late_ms", "step_ms",   "factor"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<FaultKind> read_kind(const Value& value) {
  const std::string name = value.choice({kFaultKindNames.begin(), kFaultKindNames.end()});
  const auto found = std::find(kFaultKindNames.begin(), kFaultKindNames.end(), name);
  if (found == kFaultKindNames.end()) return std::nullopt;
  return static_cast<FaultKind>(found - kFaultKindNames.begin());
}

void check_keys(const Value& value, std::optional<FaultKind> kind) {
  value.only(kEveryKey);
  if (!kind) return;
  const auto names = key_names(*kind);
  for (const auto& [key, member] : value.members()) {
    if (!contains(kEveryKey, key) || contains(names, key)) continue;
    member.fault(std::string("the fault \"") + name_of(*kind) + "\" has no \"" + key +
                 "\" (known: " + spoken_list(names) + ")");
  }
}

double read_not_zero(const Value& value, const Range& range) {
  const double number = value.number(range, 1);
  if (number == 0) value.fault("expected " + range.text() + " and not 0, got 0");
  return number;
}

/// The end of a time; endless where it is left out.
double read_end(const Value& value, double from_s) {
  const double to_s = value.number(kTime, FaultEntry{}.to_s);
  if (to_s <= from_s) value.fault("expected a time after \"from_s\"");
  return to_s;
}

/// Slow is what has a factor, or takes longer by so much, or both.
void read_slowness(const Value& value, FaultEntry& entry) {
  const Value factor = value.optional("factor"), extra = value.optional("extra_ms");
  if (!factor && !extra && value.is_object()) value.fault("\"factor\" or \"extra_ms\" is missing");
  entry.factor = factor.number(kFactor, 1);
  entry.amount_ms = extra.number(kDelay, 0);
}

FaultEntry read_entry(const Value& value) {
  FaultEntry entry;
  entry.origin = origin_of(value);
  const auto kind = read_kind(value.required("kind"));
  check_keys(value, kind);
  entry.kind = kind.value_or(entry.kind);
  entry.from_s = value.optional("from_s").number(kTime);
  entry.to_s = read_end(value.optional("to_s"), entry.from_s);
  if (!kind) return entry;
  const KindKeys& keys = keys_for(*kind);
  if (*kind != FaultKind::kClockStep) entry.at = value.required("at").string();
  if (keys.chance) entry.chance = read_not_zero(value.optional("chance"), kChance);
  if (*kind == FaultKind::kSlow) {
    read_slowness(value, entry);
  } else if (keys.amount) {
    entry.amount_ms = read_not_zero(value.required(keys.amount), keys.range);
  }
  return entry;
}

std::array<double, 2> read_lasting(const Value& value) {
  if (!value) return RandomFaults{}.lasting_s;
  const size_t faults = value.fault_count();
  const auto seconds = value.numbers(2, kLasting);
  if (value.fault_count() == faults && seconds[0] > seconds[1])
    value.fault("expected the shortest and the longest time, got the longer one first");
  return {seconds[0], seconds[1]};
}

std::vector<FaultKind> read_kinds(const Value& value) {
  std::vector<FaultKind> kinds;
  for (const Value& item : value.items()) {
    const auto kind = read_kind(item);
    if (!kind) continue;
    if (std::find(kinds.begin(), kinds.end(), *kind) != kinds.end())
      item.fault(std::string("\"") + name_of(*kind) + "\" stands twice");
    kinds.push_back(*kind);
  }
  if (value.is_array() && value.items().empty()) value.fault("expected at least one kind");
  for (size_t kind = 0; !value && kind < kFaultKinds; ++kind) kinds.push_back(static_cast<FaultKind>(kind));
  return kinds;
}

RandomFaults read_random(const Value& value) {
  value.only({"per_hour", "from_s", "to_s", "lasting_s", "kinds"});
  RandomFaults random;
  random.origin = origin_of(value);
  random.per_hour = value.required("per_hour").number(kPerHour);
  random.from_s = value.optional("from_s").number(kTime);
  random.to_s = read_end(value.required("to_s"), random.from_s);
  random.lasting_s = read_lasting(value.optional("lasting_s"));
  random.kinds = read_kinds(value.optional("kinds"));
  return random;
}

Result<FaultScript> read(const Document& document) {
  Faults faults;
  const Value root(document, faults);
  root.only({"faults", "random"});
  if (!root.is_object()) return tl::unexpected(std::move(faults));
  FaultScript script;
  script.file = document.file();
  const Value entries = root.optional("faults"), random = root.optional("random");
  if (!entries && !random) root.fault("\"faults\" or \"random\" is missing");
  for (const Value& item : entries.items()) script.entries.push_back(read_entry(item));
  if (random) script.random = read_random(random);
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return script;
}

}  // namespace

Result<FaultScript> read_fault_script(const std::filesystem::path& path) {
  const auto document = Document::read(path);
  if (!document) return tl::unexpected(document.error());
  return read(*document);
}

Result<FaultScript> parse_fault_script(const std::string& text, const std::string& file) {
  const auto document = Document::parse(text, file);
  if (!document) return tl::unexpected(document.error());
  return read(*document);
}

}  // namespace svchain
