#pragma once
// What work costs on a system on chip, as its SoC file says under "costs": cycles of a link's call by kind of
// core, latency between cores by pair of kinds, memory bandwidth. Every figure says where it is published
// ("source") or that it is assumed ("note": "assumed", which is also taken where neither is said). Figures
// may also stand in a file of their own, as `svchain profile` writes it, and win over the SoC's. Plain
// values.
//
//   cycles = per_call + per_input_px * input pixels + per_output_px * output pixels
//            + per_result, if the call has sent anything
//   bytes  = bytes_per_input_px * input pixels + bytes_per_output_px * output pixels
//
// Pixels are those of the pictures that the call takes and sends. What sends tables only (statistics, curves,
// a LUT) counts the pixels of the view instead: tables are about its pixels.

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

#include "algorithms/json/value.h"

namespace svchain {

struct CallCost {
  double per_call = 0, per_result = 0, per_input_px = 0, per_output_px = 0;  // cycles
  double bytes_per_input_px = 0, bytes_per_output_px = 0;
  std::string basis;  // a published source, or "assumed"

  double cycles(bool sent, double input_px, double output_px) const {
    return per_call + (sent ? per_result : 0) + per_input_px * input_px + per_output_px * output_px;
  }
};

struct IpcCost {
  double latency_us = 0;
  std::string basis;
};

struct MemoryCost {
  double bytes_per_s = 0;  // 0: no limit
  std::string basis;
};

struct CostModel {
  std::map<std::string, std::map<std::string, CallCost>> calls;  // by kind of core, by type of link
  std::map<std::pair<std::string, std::string>, IpcCost> ipc;    // by kinds, from -> to
  MemoryCost memory;

  /// What is taken where the file has no figure: 10 000 cycles a call and 1 for every pixel sent, no memory.
  static const CallCost kCallWithoutFigure;
  /// The same for a pair of kinds: 100 us.
  static const IpcCost kIpcWithoutFigure;

  const CallCost& call(const std::string& core_kind, const std::string& link_type) const;
  bool has_call(const std::string& core_kind, const std::string& link_type) const;
  const IpcCost& hop(const std::string& from_kind, const std::string& to_kind) const;
};

/// Where a figure, or a clock, is from: its "source", else its "note", else "assumed".
std::string read_basis(const json::Value& value);

/// Faults of the value are recorded with it.
CostModel read_cost_model(const json::Value& costs);
/// A file with nothing but {"costs": {...}}.
Result<CostModel> read_cost_file(const std::filesystem::path& path);

/// Every entry of `more` takes the place of the same entry here.
void overlay(CostModel& costs, const CostModel& more);

/// As a report shows them.
nlohmann::json to_json(const CallCost& cost);
/// As a file has them.
nlohmann::json to_file_json(const CallCost& cost);

}  // namespace svchain
