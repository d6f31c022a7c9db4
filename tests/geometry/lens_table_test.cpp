#include "algorithms/geometry/lens_table.h"

#include <cmath>
#include <fstream>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/table_lens.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::geometry;

namespace {

const TableColumns kByName = {"angle", "height"};

struct TableFile {
  explicit TableFile(const std::string& text) { std::ofstream(path()) << text; }
  std::filesystem::path path() const { return folder.path() / "lens.txt"; }
  Result<LensTable> read(const TableColumns& columns = kByName) const {
    return read_lens_table(path(), columns);
  }
  std::string only_fault(const TableColumns& columns = kByName) const {
    const auto table = read(columns);
    REQUIRE_FALSE(table);
    REQUIRE(table.error().size() == 1);
    return table.error().front().text();
  }
  testing::TemporaryFolder folder;
};

}  // namespace

TEST_CASE("a table is read by the names of its columns, whatever parts them") {
  for (const std::string part : {"\t", ";", ",", "   "}) {
    INFO("[" << part << "]");
    std::string text = "n" + part + "height" + part + "angle\n";
    for (int i = 1; i <= 5; ++i) {
      text += std::to_string(i) + part + std::to_string(0.2 * i) + part + std::to_string(10 * i) + "\r\n";
    }
    const auto table = TableFile(text).read();
    REQUIRE(table);
    CHECK(table->angle_deg == std::vector<double>{10, 20, 30, 40, 50});
    CHECK(table->height_mm[4] == 1);
  }
}

TEST_CASE("a table without a header is read by the numbers of its columns") {
  const auto table =
      TableFile("# made in 2020\n10 0.1\n\n20 2E-1\n30 +0.3\n40 0.4\n").read({size_t{0}, size_t{1}});
  REQUIRE(table);
  CHECK(table->height_mm == std::vector<double>{0.1, 0.2, 0.3, 0.4});
}

TEST_CASE("an unknown column is told with the nearest name") {
  CHECK(TableFile("angle,heigth\n1,2\n")
            .only_fault()
            .find("lens.txt:1:1: error: no column \"height\", did you mean \"heigth\"? (known: angle or "
                  "heigth)") != std::string::npos);
}

TEST_CASE("a named column in a table without a header is a fault") {
  const auto table = TableFile("1 2\n").read();
  REQUIRE_FALSE(table);
  CHECK(table.error().front().message.find("there is no header line") != std::string::npos);
}

TEST_CASE("rows that cannot be read are told by their lines, all of them") {
  const auto table = TableFile("angle,height\n1,0.1\n2,x\n3\nnan,0.4\n5,0.5\n").read();
  REQUIRE_FALSE(table);
  REQUIRE(table.error().size() == 3);
  CHECK(table.error()[0].text().find("lens.txt:3:1: error: height expected as a number, got \"x\"") !=
        std::string::npos);
  CHECK(table.error()[1].where.line == 4);
  CHECK(table.error()[2].where.line == 5);
}

TEST_CASE("of very many faulty rows the first ones are told, and how many more there are") {
  std::string text = "angle,height\n";
  for (int i = 0; i < 1000; ++i) text += "1,x\n";
  const auto table = TableFile(text).read();
  REQUIRE_FALSE(table);
  REQUIRE(table.error().size() == 11);
  CHECK(table.error().back().message == "990 more faults of this kind");
}

TEST_CASE("heights that fall and angles that do not rise are told by their lines") {
  CHECK(TableFile("angle,height\n1,0.1\n2,0.2\n3,0.15\n4,0.4\n")
            .only_fault()
            .find("lens.txt:4:1: error: heights must not fall: 0.15 after 0.2") != std::string::npos);
  CHECK(TableFile("angle,height\n1,0.1\n2,0.2\n2,0.3\n4,0.4\n")
            .only_fault()
            .find("lens.txt:4:1: error: angles must rise: 2 after 2") != std::string::npos);
}

TEST_CASE("a table of fewer than four different heights, the axis included, is refused") {
  CHECK(TableFile("angle,height\n1,0.1\n2,0.2\n").only_fault().find("at least 4 different heights") !=
        std::string::npos);
  CHECK(TableFile("angle,height\n1,0.1\n2,0.2\n3,0.2\n4,0.2\n").only_fault().find("got 3") !=
        std::string::npos);
  CHECK(TableFile("angle,height\n1,0.1\n2,0.2\n3,0.3\n").read());
}

TEST_CASE("a missing table, a folder and an empty file are refused") {
  CHECK_FALSE(read_lens_table("/nowhere/lens.txt", kByName));
  const testing::TemporaryFolder folder;
  CHECK_FALSE(read_lens_table(folder.path(), kByName));
  CHECK_FALSE(TableFile("").read());
}

TEST_CASE("a run of equal heights is one node at the mean of its angles") {
  const auto curve = lens_curve({{10, 20, 21, 22, 40, 60}, {0.1, 0.2, 0.2, 0.2, 0.4, 0.6}});
  CHECK(curve.at(radians(21)) == Approx(0.2).epsilon(1e-12));
  CHECK(curve.at(radians(20)) < 0.2);
  CHECK(curve.at(radians(22)) > 0.2);
}

TEST_CASE("heights printed as zero near the axis are the axis") {
  const auto curve = lens_curve({{0.1, 0.2, 10, 20, 30}, {0, 0, 1, 2, 3}});
  CHECK(curve.at(0) == 0);
  CHECK(curve.at(radians(0.1)) == Approx(0.01).epsilon(1e-3));
}

TEST_CASE("the curve goes through its nodes, and its inverse leads back") {
  const MonotoneCurve curve({0, 1, 2, 4, 5}, {0, 2, 2.1, 7, 7.5});
  for (const auto& [x, y] : {std::pair{1.0, 2.0}, {2.0, 2.1}, {4.0, 7.0}}) {
    CHECK(curve.at(x) == Approx(y));
    CHECK(curve.inverse(y) == Approx(x));
  }
  for (double x = 0; x <= 5; x += 0.01) CHECK(curve.inverse(curve.at(x)) == Approx(x).margin(1e-12));
}

TEST_CASE("the curve rises everywhere and its slope does not leap at the nodes") {
  const MonotoneCurve curve({0, 1, 2, 4, 5}, {0, 2, 2.1, 7, 7.5});
  bool rises = true;
  for (int i = 1; i <= 5000; ++i) rises = rises && curve.at(0.001 * i) > curve.at(0.001 * (i - 1));
  CHECK(rises);
  constexpr double kStep = 1e-6;
  for (const double node : {1.0, 2.0, 4.0}) {
    const double before = (curve.at(node) - curve.at(node - kStep)) / kStep;
    const double after = (curve.at(node + kStep) - curve.at(node)) / kStep;
    CHECK(before == Approx(after).margin(1e-4));
  }
}

TEST_CASE("a straight line stays straight") {
  const MonotoneCurve curve({0, 1, 3, 4}, {0, 2, 6, 8});
  for (double x = 0; x <= 4; x += 0.05) CHECK(curve.at(x) == Approx(2 * x).margin(1e-12));
}

TEST_CASE("heights printed to 0.01 mm are smoothed to a small part of their step") {
  LensTable table;
  for (int i = 1; i <= 900; ++i) {
    table.angle_deg.push_back(0.1 * i);
    table.height_mm.push_back(std::round(130 * radians(0.1 * i)) / 100);
  }
  const TableLens lens(table, 4.2, {0, 0});
  double worst_px = 0;
  for (double t = 0.05; t < 1.5; t += 0.001) {
    const auto pixel = lens.project({std::sin(t), 0, std::cos(t)});
    REQUIRE(pixel);
    worst_px = std::max(worst_px, std::abs(pixel->x() - 1.3 * t / 0.0042));
  }
  CHECK(worst_px < 0.35);  // the table's steps are 2.4 px, and its rows 0.54 px apart
}
