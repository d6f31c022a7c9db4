// docs/faults.md says in a table what every link does when a part fails, and what is counted of it: every
// line of the table is run, and there is no run without a line. In modelled time, without pixels.

#include "tests/integration/fault_table.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "tests/catch.h"
#include "tests/integration/faulty_run.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

using Json = nlohmann::json;
using Counts = std::map<std::string, int64_t>;

/// Fewer than in the five seconds that every run has after its faults.
constexpr int kDeliveredAfter = 4 * 30;

/// A line of the table in the docs: what it is called, and what it says is counted.
struct DocumentedLine {
  std::string name;
  Counts counts;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream rest(line.substr(1));
  for (std::string cell; std::getline(rest, cell, '|');) {
    const size_t begin = cell.find_first_not_of(' '), end = cell.find_last_not_of(' ');
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end + 1 - begin));
  }
  return cells;
}

/// "`lost` 30, `times` 30"
Counts counts_of(const std::string& cell) {
  Counts counts;
  static const std::regex kCount("`([^`]+)` ([0-9]+)");
  for (std::sregex_iterator it(cell.begin(), cell.end(), kCount), end; it != end; ++it)
    counts[(*it)[1]] = std::stoll((*it)[2]);
  return counts;
}

std::vector<DocumentedLine> documented_lines() {
  std::vector<DocumentedLine> lines;
  std::ifstream in(project_folder() / "docs" / "faults.md");
  bool in_table = false;
  for (std::string line; std::getline(in, line);) {
    in_table = in_table || line.starts_with("| fault | where ");
    if (!in_table || !line.starts_with("| ") || line.starts_with("| fault ")) continue;
    const auto cells = cells_of(line);
    REQUIRE(cells.size() == 4);
    std::string name = cells[0] + " at " + cells[1];
    std::erase(name, '`');
    lines.push_back({std::move(name), counts_of(cells[3])});
  }
  return lines;
}

FaultyRun run_of(const FaultLine& line) {
  FaultyRun run;
  run.use_case = line.use_case;
  run.faults = line.faults;
  run.may_throw = false;
  run.overrides = {"input=simulated:parking"};
  if (!line.drops_at.empty()) run.overrides.push_back(line.drops_at + ".on_error=drop");
  return run;
}

/// Of the same use case with nothing wrong, up to where the faults begin and to the end.
struct Undisturbed {
  Json at_first, at_end;
};

const Undisturbed& undisturbed(const SurroundView& world, const FaultLine& line) {
  static std::map<std::string, Undisturbed> all;
  const auto [it, is_new] = all.try_emplace(line.use_case);
  if (is_new) {
    FaultyRun run = run_of(line);
    run.faults = Json::array();
    run.overrides.resize(1);
    it->second.at_end = run_modelled(world, run);
    run.lasting_s = kFaultsBegin_s;
    it->second.at_first = run_modelled(world, run);
  }
  return it->second;
}

int64_t number_at(const Json& report, const std::string& pointer) {
  return report.value(Json::json_pointer(pointer), int64_t{0});
}

/// A name alone is a reason in "frames", "times" those of all faults, and the rest points into the report.
/// Beyond what is counted where nothing is wrong.
int64_t counted(const std::string& name, const Json& report, const Json& undisturbed) {
  if (name == "times") {
    int64_t times = 0;
    for (const Json& fault : report["faults"]["list"]) times += fault["times"].get<int64_t>();
    return times;
  }
  const std::string pointer = name.starts_with("/") ? name : "/frames/dropped/" + name;
  return number_at(report, pointer) - number_at(undisturbed, pointer);
}

/// What the line says, and nothing else among the reasons.
void check_counts(const Counts& expected, const Json& report, const Json& undisturbed) {
  for (const auto& [name, count] : expected) {
    INFO(name);
    CHECK(counted(name, report, undisturbed) == count);
  }
  for (const auto& [reason, count] : report["frames"]["dropped"].items()) {
    if (expected.contains(reason)) continue;
    INFO(reason);
    CHECK(counted(reason, report, undisturbed) == 0);
  }
}

/// A table that could not be made while all comes up is made afterwards, in its own time.
bool is_at_power_up(const Json& report) {
  return report["faults"]["list"][0]["from_s"] == 0;
}

void check_goes_on(const Json& report, const Undisturbed& undisturbed) {
  CHECK(report.value("failure", "") == "");
  CHECK(unbalanced(report) == "");
  if (is_at_power_up(report)) {
    CHECK(report["frames"]["delivered"] > 0);
    return;
  }
  CHECK(report["faults"]["recovery"]["slowest_s"].get<double>() < 1);
  const int before = undisturbed.at_first["frames"]["delivered"];
  CHECK(before > 0);
  CHECK(report["frames"]["delivered"].get<int>() >= before + kDeliveredAfter);
}

void check_line(const SurroundView& world, const FaultLine& line, const Counts& expected) {
  const Json report = run_modelled(world, run_of(line));
  const Undisturbed& base = undisturbed(world, line);
  INFO(report["frames"].dump() << " " << report["faults"].dump());
  check_counts(expected, report, base.at_end);
  if (line.ends_the_run) {
    CHECK_THAT(report.value("failure", ""),
               Catch::Matchers::Contains(line.faults[0]["at"].get<std::string>()));
  } else {
    check_goes_on(report, base);
  }
}

}  // namespace

TEST_CASE("every line of the table in docs/faults.md has its run, and every run its line") {
  std::vector<std::string> documented, run;
  for (const DocumentedLine& line : documented_lines()) documented.push_back(line.name);
  for (const FaultLine& line : fault_lines()) run.push_back(line.name);
  CHECK(documented.size() > 60);
  CHECK(documented == run);
}

TEST_CASE("when a part fails the chain does what its line in docs/faults.md says, and counts it so") {
  const SurroundView world;
  const auto& lines = fault_lines();
  for (const DocumentedLine& documented : documented_lines()) {
    const auto line = std::find_if(lines.begin(), lines.end(),
                                   [&](const FaultLine& l) { return l.name == documented.name; });
    if (line == lines.end()) continue;
    INFO(documented.name);
    check_line(world, *line, documented.counts);
  }
}

TEST_CASE("a view that display throws at is not delivered: the full rate is back only after it") {
  FaultyRun run;
  run.faults = Json::array({{{"kind", "throw"}, {"at", "display"}, {"from_s", 8}, {"to_s", 9}}});
  const SurroundView world;
  const Json recovery = run_modelled(world, run)["faults"]["recovery"];
  CHECK(recovery["after_s"] == 9);
  CHECK(recovery["slowest_s"] > 0);
}
