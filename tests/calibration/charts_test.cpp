#include "algorithms/calibration/charts.h"

#include <algorithm>

#include "tests/catch.h"

using namespace svchain::calibration;

TEST_CASE("a checkerboard has its inner corners, along x first, the square at (-x, -y) being black") {
  Chart board;
  board.squares = {5, 4};
  board.side_m = 0.25;
  const auto found = corners(board);
  REQUIRE(found.size() == 12);
  CHECK(found[0].place_m.isApprox(Eigen::Vector2d(-0.375, -0.25)));
  CHECK(found[1].place_m.isApprox(Eigen::Vector2d(-0.125, -0.25)));
  CHECK(found[0].dark == 0b0101);
  CHECK(found[1].dark == 0b1010);
  CHECK(found[4].dark == 0b1010);
}

TEST_CASE("squares that touch at their corners share them, and the shared ones are saddles") {
  Chart mat;
  mat.type = ChartType::kSquares;
  mat.side_m = 0.4;
  mat.centres_m = {{0, 0}, {0.4, 0.4}, {2, 0}};
  const auto found = corners(mat);
  CHECK(found.size() == 11);
  CHECK(std::count_if(found.begin(), found.end(), [](const auto& c) { return c.is_saddle(); }) == 1);
}

TEST_CASE("a corner reaches as far as no other square comes") {
  Chart mat;
  mat.type = ChartType::kSquares;
  mat.side_m = 0.8;
  mat.centres_m = {{0, 0}, {0.9, 0}};
  const auto found = corners(mat);
  REQUIRE(found.size() == 8);
  CHECK(found[0].reach_m == Approx(0.8));
  CHECK(found[1].reach_m == Approx(0.1));
}
