#include "framework/usecase/cost_model.h"

#include <nlohmann/json.hpp>

namespace svchain {

namespace {

using json::Range;
using json::Value;

constexpr Range kCycles = {0, 1e15, "cycles"};
constexpr Range kBytes = {0, 1e6, "bytes"};
constexpr const char* kAssumed = "assumed";
constexpr const char* kArrow = " -> ";
constexpr const char* kNoFigure = "default, no figure in the SoC file";

struct Term {
  const char* key;
  double CallCost::*value;
  Range range;
};
const std::vector<Term> kTerms = {{"per_call", &CallCost::per_call, kCycles},
                                  {"per_result", &CallCost::per_result, kCycles},
                                  {"per_input_px", &CallCost::per_input_px, kCycles},
                                  {"per_output_px", &CallCost::per_output_px, kCycles},
                                  {"bytes_per_input_px", &CallCost::bytes_per_input_px, kBytes},
                                  {"bytes_per_output_px", &CallCost::bytes_per_output_px, kBytes}};

CallCost read_call(const Value& value) {
  std::vector<std::string> keys = {"source", "note"};
  for (const Term& term : kTerms) keys.emplace_back(term.key);
  value.only(keys);
  CallCost cost;
  for (const Term& term : kTerms) cost.*term.value = value.optional(term.key).number(term.range);
  cost.basis = read_basis(value);
  return cost;
}

void read_hop(const std::string& kinds, const Value& value, CostModel& model) {
  value.only({"latency_us", "source", "note"});
  const IpcCost cost = {value.required("latency_us").number({0, 1e6, "us"}), read_basis(value)};
  const size_t arrow = kinds.find(kArrow);
  if (arrow == std::string::npos || arrow == 0 || arrow + 4 == kinds.size())
    return value.fault("expected two kinds of cores, as in \"M4 -> C66x\", got \"" + kinds + "\"");
  model.ipc[{kinds.substr(0, arrow), kinds.substr(arrow + 4)}] = cost;
}

void put_terms(const CallCost& cost, nlohmann::json& json) {
  for (const Term& term : kTerms) {
    if (cost.*term.value != 0) json[term.key] = cost.*term.value;
  }
}

}  // namespace

std::string read_basis(const Value& value) {
  const std::string source = value.optional("source").string();
  const std::string note = value.optional("note").string(kAssumed);
  return source.empty() ? note : source;
}

const CallCost CostModel::kCallWithoutFigure = {10'000, 0, 0, 1, 0, 0, kNoFigure};
const IpcCost CostModel::kIpcWithoutFigure = {100, kNoFigure};

bool CostModel::has_call(const std::string& core_kind, const std::string& link_type) const {
  const auto kind = calls.find(core_kind);
  return kind != calls.end() && kind->second.contains(link_type);
}

const CallCost& CostModel::call(const std::string& core_kind, const std::string& link_type) const {
  return has_call(core_kind, link_type) ? calls.at(core_kind).at(link_type) : kCallWithoutFigure;
}

const IpcCost& CostModel::hop(const std::string& from_kind, const std::string& to_kind) const {
  const auto found = ipc.find({from_kind, to_kind});
  return found == ipc.end() ? kIpcWithoutFigure : found->second;
}

CostModel read_cost_model(const Value& costs) {
  CostModel model;
  if (!costs) return model;
  costs.only({"cycles", "ipc", "memory"});
  for (const auto& [kind, links] : costs.optional("cycles").members()) {
    for (const auto& [type, value] : links.members()) model.calls[kind][type] = read_call(value);
  }
  for (const auto& [kinds, value] : costs.optional("ipc").members()) read_hop(kinds, value, model);
  if (const Value memory = costs.optional("memory")) {
    memory.only({"bytes_per_s", "source", "note"});
    model.memory = {memory.required("bytes_per_s").number({1, 1e15, "bytes/s"}), read_basis(memory)};
  }
  return model;
}

Result<CostModel> read_cost_file(const std::filesystem::path& path) {
  const auto document = json::Document::read(path);
  if (!document) return tl::unexpected(document.error());
  Faults faults;
  const Value root(*document, faults);
  root.only({"costs"});
  CostModel costs = read_cost_model(root.required("costs"));
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return costs;
}

void overlay(CostModel& costs, const CostModel& more) {
  for (const auto& [kind, links] : more.calls) {
    for (const auto& [type, cost] : links) costs.calls[kind][type] = cost;
  }
  for (const auto& [kinds, cost] : more.ipc) costs.ipc[kinds] = cost;
  if (more.memory.bytes_per_s > 0) costs.memory = more.memory;
}

nlohmann::json to_json(const CallCost& cost) {
  nlohmann::json json = {{"basis", cost.basis}};
  put_terms(cost, json);
  return json;
}

nlohmann::json to_file_json(const CallCost& cost) {
  nlohmann::json json = {{cost.basis.starts_with(kAssumed) ? "note" : "source", cost.basis}};
  put_terms(cost, json);
  return json;
}

}  // namespace svchain
