#include "usecases/svchain_bench/performance_page.h"

#include <stdexcept>

#include "tests/catch.h"
#include "usecases/svchain_bench/performance_table.h"

using namespace svchain::bench;
using Catch::Matchers::Contains;

namespace {

Measured made_up() {
  Measured measured;
  measured.results.ratios["synthesis.avx2.1t"] = {5, 4.8, 5.2, 25, 5};
  measured.results.ratios["hop.stream_vs_asio_post"] = {2.5, 2.4, 2.6, 500, 200};
  measured.results.ratios["hop.spin_park_rtt_over_raw_ring"] = {1.4, 1.3, 1.6, 1400, 1000};
  measured.results.ratios["hop.stream_vs_carrier_pigeon"] = {9000, 8000, 9999, 1e6, 110};
  measured.results.missing["hop.stream_vs_gstreamer_queue"] = "not installed";
  measured.results.figures["hop.same_core_ns"] = 130;
  measured.growth.sizes = {{440, 540, 1, 200'000}, {880, 1080, 4, 800'000}, {1760, 2160, 24, 3'000'000}};
  measured.growth.lines = {{1, 200, 400, {}}, {2, 300, 900, 150}};
  measured.growth.cameras = {{2, 110, 210, {}}, {4, 120, 230, 4.5}};
  measured.machine = {"a machine", "a compiler", "4.6.0"};
  measured.versions = {{"OpenCV", "4.6.0"}, {"TBB", "not installed"}};
  measured.date = "2024-03-31";
  return measured;
}

std::string page_of(const Measured& measured) {
  return performance_page(measured, "performance").front().second;
}

/// The line of a table that is about this.
std::string row(const std::string& page, const std::string& name) {
  const size_t at = page.find("\n| " + name + " |");
  return at == std::string::npos ? "" : page.substr(at + 1, page.find('\n', at + 1) - at - 1);
}

}  // namespace

TEST_CASE("the page says where, with what and when it was measured") {
  CHECK_THAT(page_of(made_up()),
             Contains("2024-03-31; a machine; a compiler; OpenCV 4.6.0; TBB not installed."));
}

TEST_CASE("a ratio stands beside its quartiles, its goal, whether that is met, and both costs") {
  const std::string page = page_of(made_up());
  CHECK(row(page, "`synthesis.avx2.1t`") ==
        "| `synthesis.avx2.1t` | B | 5.00 | 4.80 to 5.20 | at least 4.5 | yes | 5.00 | 25.0 |");
  CHECK(row(page, "`hop.stream_vs_asio_post`") ==
        "| `hop.stream_vs_asio_post` | asio::post | 2.50 | 2.40 to 2.60 | at least 3 | **no** | 200 | 500 |");
}

TEST_CASE("of a ratio that is ours over the other's, ours is the first cost, and less is better") {
  CHECK(
      row(page_of(made_up()), "`hop.spin_park_rtt_over_raw_ring`") ==
      "| `hop.spin_park_rtt_over_raw_ring` | ring, spinning | 1.40 | 1.30 to 1.60 | at most 1.5 | yes | 1400 "
      "| 1000 |");
}

TEST_CASE("sets of more cameras stand one below the other, synthesis only of as many as a rig has") {
  const std::string page = page_of(made_up());
  CHECK_THAT(page, Contains("| 2 | 110 | 210 |  |"));
  CHECK_THAT(page, Contains("| 4 | 120 | 230 | 4.50 |"));
}

TEST_CASE("what is missing says why, or that it was not measured") {
  const std::string page = page_of(made_up());
  CHECK_THAT(row(page, "`hop.stream_vs_gstreamer_queue`"),
             Contains("| not installed |") && Contains("at least 15"));
  CHECK_THAT(row(page, "`synthesis.avx512.2t`"), Contains("| not measured |"));
  for (const char* name : {"`bowl.gpu_fps`", "`bowl.gpu_upload_ms`", "`bowl.gpu_upload_nv12_ms`",
                           "`bowl.gpu_draw_ms`", "`bowl.gpu_read_back_ms`"})
    CHECK_THAT(row(page, name), Contains("| not measured |"));
}

TEST_CASE("a figure is judged by its goal") {
  CHECK(row(page_of(made_up()), "`hop.same_core_ns`") ==
        "| `hop.same_core_ns` | 130 | at most 100 | **no** |");
}

TEST_CASE("what is measured and has no goal is on the page, too") {
  CHECK_THAT(row(page_of(made_up()), "`hop.stream_vs_carrier_pigeon`"), Contains("| 9000 |"));
}

TEST_CASE("the summary counts goals and names those that are missed or not measured") {
  const Tally tally = tally_of(made_up().results);
  CHECK(tally.missed == std::vector<std::string>{"`hop.stream_vs_asio_post`", "`hop.same_core_ns`"});
  CHECK(tally.goals == 16);
  CHECK(tally.not_measured.size() == 12);
  CHECK_THAT(page_of(made_up()),
             Contains("2 of 16 goals are met. Missed: `hop.stream_vs_asio_post`, `hop.same_core_ns`."));
}

TEST_CASE("cost per pixel is given for every size, and its spread is judged") {
  const std::string page = page_of(made_up());
  CHECK(row(page, "880x1080") == "| 880x1080 | 84.2 % | 4.00 | 4.21 | 5.00 |");
  CHECK(row(page, "**largest over smallest**") == "| **largest over smallest** |  |  | 1.50 | 1.60 |");
  CHECK(row(page, "at most 1.2") == "| at most 1.2 |  |  | **no** | **no** |");
}

TEST_CASE("a spread is the largest over the smallest") {
  CHECK(spread({2, 8, 4}) == 4);
  CHECK_THROWS_AS(spread({}), std::invalid_argument);
}

TEST_CASE("cost of a line of links is given per frame and per hop") {
  CHECK(row(page_of(made_up()), "2") == "| 2 | 300 | 100 | 900 | 300 | 150 | 50.0 |");
  CHECK(row(page_of(made_up()), "1") == "| 1 | 200 | 100 | 400 | 200 | not installed |  |");
}

TEST_CASE("the page shows the plots that are written beside it") {
  const Files files = performance_page(made_up(), "speed");
  REQUIRE(files.size() == 4);
  CHECK(files[0].first == "speed.md");
  for (size_t i = 1; i < files.size(); ++i) {
    INFO(files[i].first);
    CHECK_THAT(files[0].second, Contains("](" + files[i].first + ")"));
    CHECK(files[i].second.starts_with("<svg "));
  }
  CHECK_THAT(files[1].second, Contains("synthesis.avx2.1t"));
}

TEST_CASE("a page of nothing measured can be written") {
  const Files files = performance_page({}, "performance");
  CHECK_THAT(files.front().second, Contains("0 of 16 goals are met. Not measured here: "));
}
