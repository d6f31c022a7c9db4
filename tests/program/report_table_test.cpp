// The table that a run ends with.

#include "framework/statistics/report_table.h"

#include <nlohmann/json.hpp>

#include "tests/catch.h"

using Catch::Matchers::Contains;

TEST_CASE("the table names what was dropped and why, who held a buffer, and what was written") {
  const auto report = nlohmann::json::parse(R"({
    "usecase": "u", "soc": "s", "frames": {"captured": 10, "delivered": 7, "dropped": {"late": 2, "full": 1, "none": 0}},
    "wall_s": 1.0, "fps": 7.0, "cores": {"DSP1": {"load": 0.25}},
    "links": {"a": {"core": "DSP1", "processed": 7, "process_ms": {"p50": 1, "p99": 2, "max": 3}, "dropped": {"late": 2}}},
    "edges": {"a.x -> b.y": {"ipc": true, "messages": 7, "hop_us": {"p50": 1.5, "p99": 2.5}, "full": 0},
              "a.x -> c.y": {"ipc": false, "messages": 7, "full": 0}},
    "pools": {"a.x": {"buffers": 4, "high_water": 3, "outstanding_at_stop": 1, "held_by": {"b": 1}}},
    "output": {"path": "view.png"}})");
  const std::string table = svchain::report_table(report);
  CHECK_THAT(table, Contains("u on s: 10 frames captured, 7 delivered, dropped: full 1, late 2;"));
  CHECK_THAT(table,
             Contains("25.0") && Contains("late 2") && Contains("b 1") && Contains("written: view.png"));
  CHECK_THAT(table, Contains("a.x -> b.y") && !Contains("a.x -> c.y"));
}

TEST_CASE("the table of an empty report is a line") {
  CHECK(svchain::report_table(nlohmann::json::parse(R"({"usecase": "u", "soc": "s"})")) == "u on s\n");
}

TEST_CASE("the table of a modelled run says what it comes to after power-up") {
  const auto report = nlohmann::json::parse(R"({"usecase": "u", "soc": "s", "after_power_up":
    {"from_s": 7.03, "fps": 30.0, "dropped": 0, "cores": {"DSP1": {"load": 0.03}, "DSP2": {"load": 0.75}}}})");
  CHECK_THAT(svchain::report_table(report),
             Contains("modelled, from 7.03 s on: 30.00 frames/s, 0 dropped, DSP1 3.0 %, DSP2 75.0 %\n"));
}
