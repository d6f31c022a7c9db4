#include "usecases/svchain_page/document.h"

#include <cmath>

#include "tests/catch.h"

using namespace svchain::page;

TEST_CASE("a section is a heading, prose and tables in Markdown") {
  const Section section{"Time", "How long.\n", {{{"stage", "ms"}, {{"corners", "12"}}}}};
  CHECK(markdown(section) == "## Time\n\nHow long.\n\n| stage | ms |\n| --- | --- |\n| corners | 12 |\n\n");
}

TEST_CASE("figures have two or three digits, whatever their size") {
  CHECK(figure(123.4) == "123");
  CHECK(figure(12.34) == "12.3");
  CHECK(figure(1.234) == "1.23");
  CHECK(figure(0.01234) == "0.012");
  CHECK(figure(0.001234) == "0.0012");
}

TEST_CASE("what is no number does not meet a limit") {
  CHECK(met(1, 1) == "yes");
  CHECK(met(1.1, 1) == "**no**");
  CHECK(met(std::nan(""), 1) == "**no**");
}
