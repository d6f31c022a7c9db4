// What is printed: true sizes, black where the chart is black, and files that readers accept.

#include "algorithms/calibration/print_charts.h"

#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "algorithms/calibration/tag_finder.h"
#include "tests/catch.h"

using namespace svchain::calibration;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

constexpr double kPointsPerMetre = 72 / 0.0254;

Chart tag_chart() {
  Chart chart;
  chart.name = "tags";
  chart.type = ChartType::kAprilTag36h11;
  chart.side_m = 0.16;
  chart.tags = {{5, {0, 0}}, {9, {0.4, 0.1}}};
  return chart;
}

Chart carpet(double length_m) {
  Chart chart;
  chart.name = "carpet (large)";
  chart.type = ChartType::kSquares;
  chart.side_m = 0.5;
  chart.centres_m = {{0, 0}, {length_m, 0.5}};
  return chart;
}

cv::Mat decoded(const std::string& png) {
  return cv::imdecode(std::vector<uint8_t>(png.begin(), png.end()), cv::IMREAD_GRAYSCALE);
}

/// Pixels per metre that the file says, by its chunk pHYs.
uint32_t density_of(const std::string& png) {
  const size_t at = png.find("pHYs");
  REQUIRE(at != std::string::npos);
  REQUIRE(png.substr(at + 4, 4) == png.substr(at + 8, 4));
  REQUIRE(png[at + 12] == 1);  // the unit is the metre
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(png[at + 4 + i]);
  return value;
}

/// Grey level of the printed picture at a place of the sheet.
int grey_at(const cv::Mat& picture, const Sheet& sheet, const Eigen::Vector2d& place_m) {
  const double px_per_metre = picture.cols / sheet.size_m.x();
  return picture.at<uint8_t>(picture.rows - 1 - static_cast<int>(place_m.y() * px_per_metre),
                             static_cast<int>(place_m.x() * px_per_metre));
}

size_t number_after(const std::string& text, const std::string& key, size_t from = 0) {
  const size_t at = text.find(key, from);
  REQUIRE(at != std::string::npos);
  return static_cast<size_t>(std::stoull(text.substr(at + key.size())));
}

/// Width and height in metres of each page.
std::vector<Eigen::Vector2d> page_sizes(const std::string& pdf) {
  std::vector<Eigen::Vector2d> sizes;
  for (size_t at = pdf.find("/MediaBox"); at != std::string::npos; at = pdf.find("/MediaBox", at + 1)) {
    double width = 0, height = 0, unit = 1;
    const std::string page = pdf.substr(at, pdf.find("endobj", at) - at);
    REQUIRE(std::sscanf(page.c_str(), "/MediaBox [0 0 %lf %lf] /UserUnit %lf", &width, &height, &unit) >= 2);
    CHECK(std::max(width, height) <= 14400);
    sizes.push_back(Eigen::Vector2d(width, height) * unit / kPointsPerMetre);
  }
  return sizes;
}

/// Follows a PDF file's own structure: from its end to the table, from there to every object and stream.
void check_structure(const std::string& pdf) {
  const size_t table = number_after(pdf, "startxref\n");
  REQUIRE(pdf.compare(table, 7, "xref\n0 ") == 0);
  const size_t count = number_after(pdf, "xref\n0 ", table);
  CHECK(number_after(pdf, "/Size ", table) == count);
  const size_t first = pdf.find('\n', table + 5) + 1;
  for (size_t i = 0; i < count; ++i) {
    const std::string entry = pdf.substr(first + 20 * i, 20);
    CHECK(entry.substr(10) == (i == 0 ? " 65535 f \n" : " 00000 n \n"));
    if (i > 0) {
      const size_t offset = std::stoull(entry);
      CHECK_THAT(pdf.substr(offset, 20), StartsWith(std::to_string(i) + " 0 obj\n"));
    }
  }
  CHECK(pdf.compare(first + 20 * count, 8, "trailer\n") == 0);
  for (size_t at = pdf.find("stream\n"); at < table; at = pdf.find("\nstream\n", at + 1)) {
    const size_t begin = pdf.find("stream\n", at) + 7;
    const size_t length = number_after(pdf, "/Length ", pdf.rfind("/Length", at));
    CHECK(pdf.compare(begin + length, 9, "endstream") == 0);
  }
  CHECK(pdf.substr(pdf.size() - 6) == "%%EOF\n");
}

}  // namespace

TEST_CASE("the usual chart takes 1.5 m by 1.25 m and a strip for its labels") {
  const Sheet sheet = sheet_of(usual_chart());
  CHECK(sheet.size_m.x() == Approx(1.5));
  CHECK(sheet.size_m.y() > 1.25);
  CHECK(sheet.size_m.y() < 1.35);
  for (const auto& label : sheet.labels) CHECK(label.place_m.y() + label.height_m < sheet.size_m.y() - 1.25);
}

TEST_CASE("a checkerboard is printed with the square at (-x, -y) black, half a square of white around") {
  const Sheet sheet = sheet_of(usual_chart());
  const std::string png = png_of(sheet);
  const cv::Mat picture = decoded(png);
  CHECK(picture.cols == std::lround(1.5 * density_of(png)));
  const double below = sheet.size_m.y() - 1.25;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 5; ++i) {
      const Eigen::Vector2d low(0.125 + 0.25 * i, below + 0.125 + 0.25 * j);
      const int expected = (i + j) % 2 == 0 ? 0 : 255;
      for (const double u : {0.001, 0.125, 0.249}) {
        for (const double v : {0.001, 0.125, 0.249}) {
          CHECK(grey_at(picture, sheet, low + Eigen::Vector2d(u, v)) == expected);
        }
      }
    }
  }
  for (const double x : {0.06, 0.124, 1.376, 1.49}) CHECK(grey_at(picture, sheet, {x, 0.5}) == 255);
}

TEST_CASE("printed tags are found where they were to be printed") {
  const Chart chart = tag_chart();
  const Sheet sheet = sheet_of(chart);
  const std::string png = png_of(sheet);
  const double density = density_of(png);
  const cv::Mat picture = decoded(png);
  const auto found = find_tags(picture);
  REQUIRE(found.size() == 2);
  const double strip_m = sheet.size_m.y() - (0.1 + 0.16 + 0.16);
  for (const auto& tag : found) {
    const Eigen::Vector2d place = tag.id == 5 ? chart.tags[0].place_m : chart.tags[1].place_m;
    CHECK((tag.id == 5 || tag.id == 9));
    // The first corner, (-x, -y), is the lower left one; the white around is half a tag.
    const Eigen::Vector2d lower_left = place + Eigen::Vector2d(0.08, 0.08 + strip_m);
    CHECK(std::abs((tag.corners_px[0].x() + 0.5) / density - lower_left.x()) < 0.0005);
    CHECK(std::abs((picture.rows - 0.5 - tag.corners_px[0].y()) / density - lower_left.y()) < 0.0005);
    CHECK((tag.corners_px[1] - tag.corners_px[0]).norm() / density == Approx(0.16).margin(0.0005));
    CHECK(tag.corners_px[2].y() < tag.corners_px[1].y());
  }
}

TEST_CASE("a PDF has a page in true size for each chart") {
  const std::string pdf = pdf_of({sheet_of(usual_chart()), sheet_of(tag_chart()), sheet_of(carpet(3))});
  CHECK_THAT(pdf, StartsWith("%PDF-1.4\n"));
  check_structure(pdf);
  CHECK_THAT(pdf, Contains("/Count 3"));
  const auto sizes = page_sizes(pdf);
  REQUIRE(sizes.size() == 3);
  CHECK(sizes[0].x() == Approx(1.5).margin(1e-6));
  CHECK(sizes[1].x() == Approx(0.4 + 0.16 + 0.16).margin(1e-6));
  CHECK(sizes[2].x() == Approx(3.0 + 0.5 + 0.5).margin(1e-6));
  CHECK_THAT(pdf, Contains("(carpet \\(large\\): 2 squares of 50 cm)") && Contains("Print at 100 %"));
  // The usual chart's first square, its lower left corner in points.
  const double left = 0.125 * kPointsPerMetre;
  char corner[32];
  std::snprintf(corner, sizeof corner, "%.4f ", left);
  CHECK_THAT(pdf, Contains(corner));
}

TEST_CASE("a carpet beyond the largest page is told in larger units, in true size still") {
  const std::string pdf = pdf_of({sheet_of(usual_chart()), sheet_of(carpet(10))});
  CHECK_THAT(pdf, StartsWith("%PDF-1.6\n"));
  check_structure(pdf);
  const auto sizes = page_sizes(pdf);
  REQUIRE(sizes.size() == 2);
  CHECK(sizes[0].x() == Approx(1.5).margin(1e-6));
  CHECK(sizes[1].x() == Approx(11).margin(1e-6));
}
