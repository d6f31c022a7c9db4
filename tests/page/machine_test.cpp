#include "usecases/svchain_page/machine.h"

#include <regex>

#include "tests/catch.h"

using namespace svchain::page;

TEST_CASE("the processor, the compiler, OpenCV and the day have names") {
  CHECK_FALSE(processor().empty());
  CHECK(compiler().starts_with("g++ "));
  CHECK(std::regex_match(opencv_version(), std::regex(R"(\d+\.\d+\.\d+.*)")));
  CHECK(std::regex_match(today(), std::regex(R"(\d{4}-\d{2}-\d{2})")));
}
