#include <regex>
#include <stdexcept>

#include "tests/catch.h"
#include "usecases/svchain_page/bar_chart.h"
#include "usecases/svchain_page/line_plot.h"

using namespace svchain::page;

namespace {

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Where an attribute says something, for every element of a kind, in their order.
std::vector<double> attributes(const std::string& svg, const std::string& element, const std::string& name) {
  const std::regex pattern("<" + element + "[^>]* " + name + "=\"([-0-9.]+)\"");
  std::vector<double> values;
  for (auto found = std::sregex_iterator(svg.begin(), svg.end(), pattern); found != std::sregex_iterator();
       ++found)
    values.push_back(std::stod((*found)[1]));
  return values;
}

}  // namespace

TEST_CASE("a bar is as long as the logarithm of its ratio, and begins at 1") {
  const std::string svg =
      bar_chart("Ratios", "times", {{"all", {{"four", 4, 4, 4, {}}, {"half", 0.5, 0.5, 0.5, {}}}}});
  // The bars come last.
  const auto x = attributes(svg, "rect", "x"), width = attributes(svg, "rect", "width");
  REQUIRE(x.size() >= 2);
  const double from = x[x.size() - 2], four = width[width.size() - 2];
  const double half_from = x.back(), half = width.back();
  CHECK(four == Approx(2 * half).margin(0.3));
  CHECK(half_from + half == Approx(from).margin(0.3));
}

TEST_CASE("a bar says by its colour, and that of its number, whether its goal is met") {
  const auto colours = [](const Bar& bar) { return bar_chart("", "", {{"", {bar}}}); };
  const std::string met = colours({"a", 4, 4, 4, 3, true});
  const std::string missed = colours({"a", 2, 2, 2, 3, false});
  const std::string plain = colours({"a", 2, 2, 2, {}, true});
  CHECK(count_of(met, "#4f9a4d") == 3);  // the legend's, the bar's and its number's
  CHECK(count_of(met, "#c0392b") == 1);
  CHECK(count_of(missed, "#c0392b") == 3);
  CHECK(count_of(plain, "#4a7fb5") == 2);
}

TEST_CASE("a bar chart without bars is a picture nevertheless") {
  const std::string svg = bar_chart("Nothing", "times", {{"empty", {}}});
  CHECK(svg.starts_with("<svg "));
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(svg.find("empty") == std::string::npos);
}

TEST_CASE("a ratio that is not above 0 is refused by name") {
  CHECK_THROWS_WITH(bar_chart("", "", {{"", {{"broken", 0, 1, 1, {}}}}}),
                    Catch::Matchers::Contains("broken"));
}

TEST_CASE("a line plot has a dot for every point, and the highest is at the top") {
  const std::string svg =
      line_plot({"Growth", "links", "cost, ns", {{"one core", {{1, 10}, {2, 20}, {4, 15}}}}, false});
  const auto x = attributes(svg, "circle", "cx"), y = attributes(svg, "circle", "cy");
  REQUIRE(x.size() == 4);  // the legend's first
  CHECK(x[2] - x[1] == Approx(x[3] - x[2]).margin(0.2));
  CHECK(y[2] < y[3]);
  CHECK(y[3] < y[1]);
  for (const char* text : {"Growth", "links", "cost, ns", "one core"}) {
    INFO(text);
    CHECK(svg.find(text) != std::string::npos);
  }
}

TEST_CASE("an axis of y that doubles puts doubles at equal distances") {
  const std::string svg = line_plot({"", "", "", {{"", {{1, 3}, {2, 6}, {4, 12}}}}, true});
  const auto y = attributes(svg, "circle", "cy");
  REQUIRE(y.size() == 4);
  CHECK(y[1] - y[2] == Approx(y[2] - y[3]).margin(0.2));
}

TEST_CASE("series without points are left out, and one point alone is drawn") {
  const std::string svg = line_plot({"", "", "", {{"none", {}}, {"single", {{4, 1}}}}, false});
  CHECK(svg.find("none<") == std::string::npos);
  CHECK(attributes(svg, "circle", "cx").size() == 2);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("a point that has no logarithm is refused by the name of its series") {
  CHECK_THROWS_WITH(line_plot({"", "", "", {{"broken", {{0, 1}}}}, false}),
                    Catch::Matchers::Contains("broken"));
  CHECK_THROWS_WITH(line_plot({"", "", "", {{"broken", {{1, 0}}}}, true}),
                    Catch::Matchers::Contains("broken"));
}

TEST_CASE("names stand in a plot as they are, even with characters that SVG keeps for itself") {
  const std::string svg = line_plot({"a < b & c", "", "", {{"", {{1, 1}}}}, false});
  CHECK(svg.find("a &lt; b &amp; c") != std::string::npos);
}
