// Charts checked and printed.

#include <opencv2/imgcodecs.hpp>

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const char* const kTwo = R"({"charts":[
 {"name":"left","type":"checkerboard","squares":[4,3],"square_m":0.02},
 {"name":"right/rear","type":"apriltag_36h11","tag_m":0.08,"tags":[{"id":3,"x_m":0,"y_m":0}]}]})";

}  // namespace

TEST_CASE("the usual chart is printed where no other is asked for") {
  const TemporaryFolder folder;
  const auto outcome = svchain_program({"charts", "--output", folder.path() / "charts.pdf"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const std::string pdf = read_text(folder.path() / "charts.pdf");
  CHECK_THAT(pdf, StartsWith("%PDF-1.4"));
  CHECK_THAT(pdf, Contains("5 x 4 squares of 25 cm") && Contains("/Count 1"));
  REQUIRE(svchain_program({"charts", "--output", folder.path() / "charts.png"}).status == 0);
  CHECK_FALSE(cv::imread((folder.path() / "charts.png").string()).empty());
  CHECK(count_of(folder.path()) == 2);
}

TEST_CASE("a file's charts become pages of one PDF, or a picture each") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "two.json";
  write_text(file, kTwo);
  REQUIRE(svchain_program({"charts", "--charts", file, "--output", folder.path() / "two.pdf"}).status == 0);
  CHECK_THAT(read_text(folder.path() / "two.pdf"), Contains("/Count 2"));
  const auto pictures = svchain_program({"charts", "--charts", file, "--output", folder.path() / "two.png"});
  INFO(pictures.err);
  REQUIRE(pictures.status == 0);
  CHECK_FALSE(cv::imread((folder.path() / "two-left.png").string()).empty());
  CHECK_FALSE(cv::imread((folder.path() / "two-right_rear.png").string()).empty());
  CHECK(count_of(folder.path()) == 4);
}

TEST_CASE(
    "charts that cannot be printed are told with the file's faults and the option's, and nothing is "
    "written") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "bad.json";
  write_text(file, R"({"charts":[{"name":"a","type":"checkerboard","squares":[4,1],"square_m":0.02}]})");
  const auto outcome = svchain_program({"charts", "--charts", file, "--output", folder.path() / "bad.jpg"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("bad.json:1:59: error: /charts/0/squares/1: expected 2 to 100, got 1") &&
                              Contains("expected a .pdf or .png file"));
  CHECK(count_of(folder.path()) == 1);
}

TEST_CASE("two charts that would be one picture are refused") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "twins.json";
  write_text(file, R"({"charts":[{"name":"a/b","type":"checkerboard","squares":[4,3],"square_m":0.02},
    {"name":"a_b","type":"checkerboard","squares":[4,3],"square_m":0.02}]})");
  const auto outcome = svchain_program({"charts", "--charts", file, "--output", folder.path() / "x.png"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("two charts would be"));
  CHECK(count_of(folder.path()) == 1);
}

TEST_CASE("validate checks charts, and svchain simulate writes sound ones") {
  const TemporaryFolder folder;
  write_text(folder.path() / "two.json", kTwo);
  REQUIRE(svchain_program({"simulate", "--scene", "toy", "--output", folder.path() / "toy"}).status == 0);
  const auto sound =
      svchain_program({"validate", folder.path() / "two.json", folder.path() / "toy" / "charts.json"});
  INFO(sound.err);
  CHECK(sound.status == 0);
  CHECK_THAT(sound.out, Contains("two.json: ok (charts)") && Contains("charts.json: ok (charts)"));
  write_text(folder.path() / "bad.json",
             R"({"charts":[{"name":"a","type":"squares","side_m":1,"centres_m":[]}]})");
  const auto bad = svchain_program({"validate", folder.path() / "bad.json"});
  CHECK(bad.status == 2);
  CHECK_THAT(bad.err, Contains("/charts/0/centres_m: expected at least one square"));
}
