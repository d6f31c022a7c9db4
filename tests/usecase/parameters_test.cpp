#include "framework/link/parameters.h"

#include <stdexcept>

#include "algorithms/json/document.h"
#include "tests/catch.h"
#include "tests/usecase/expect.h"
#include "tests/usecase/fake_links.h"

namespace svchain {

namespace {

using testing::check_fault;

std::vector<ParameterDescription> every_kind() {
  ParameterDescription size;
  size.name = "size_px";
  size.kind = Kind::kNumbers;
  size.count = 2;
  size.fallback = {4, 3};
  size.range = {1, 8192};
  size.unit = "px";
  return {boolean("mirror", false, ""),
          integer("depth", 4, {1, 64}, "frames", ""),
          number("delta_ms", 10, {0, 1000}, "ms", ""),
          text("name", "x", ""),
          path("file", ""),
          choice("kernel", "automatic", {"automatic", "portable", "avx2"}, ""),
          size};
}

Faults faults_of(const std::string& text) {
  const auto document = json::Document::parse(text, "p.json");
  REQUIRE(document);
  Faults faults;
  Parameters parameters(every_kind());
  parameters.read(every_kind(), json::Value(*document, faults));
  return faults;
}

}  // namespace

TEST_CASE("parameters that are not given have their fallbacks") {
  const Parameters p(every_kind());
  CHECK_FALSE(p.flag("mirror"));
  CHECK(p.integer("depth") == 4);
  CHECK(p.number("delta_ms") == 10);
  CHECK(p.text("name") == "x");
  CHECK(p.text("kernel") == "automatic");
  CHECK(p.numbers("size_px") == std::vector<double>{4, 3});
  CHECK_FALSE(p.given("file"));
}

TEST_CASE("parameters of every kind are read from a file") {
  const auto document = json::Document::parse(
      R"({"mirror":true,"depth":7.0,"delta_ms":2.5,"name":"y","file":"a.bin","kernel":"avx2","size_px":[640,480]})",
      "");
  REQUIRE(document);
  Faults faults;
  Parameters p(every_kind());
  p.read(every_kind(), json::Value(*document, faults));
  CHECK(faults.empty());
  CHECK(p.flag("mirror"));
  CHECK(p.integer("depth") == 7);
  CHECK(p.number("delta_ms") == 2.5);
  CHECK(p.text("name") == "y");
  CHECK(p.text("file") == "a.bin");
  CHECK(p.text("kernel") == "avx2");
  CHECK(p.numbers("size_px") == std::vector<double>{640, 480});
}

TEST_CASE("every wrong parameter is reported, with place, what was expected and its unit") {
  const auto faults = faults_of(
      "{\"mirror\": 1,\n\"depth\": 2.5,\n\"delta_ms\": 5000,\n\"name\": 3,\n"
      "\"kernel\": \"portabel\",\n\"size_px\": [640, 0],\n\"dept\": 1}");
  CHECK(faults.size() == 7);
  check_fault(faults, "p.json:1:12: error: /mirror", {"expected true or false, got 1"});
  check_fault(faults, "p.json:2:10: error: /depth", {"expected a whole number, got 2.5"});
  check_fault(faults, "p.json:3:13: error: /delta_ms", {"expected 0 to 1000 ms, got 5000"});
  check_fault(faults, "p.json:4:9: error: /name", {"expected a string, got 3"});
  check_fault(faults, "p.json:5:11: error: /kernel",
              {"automatic, portable or avx2", "did you mean \"portable\"?"});
  check_fault(faults, "p.json:6:18: error: /size_px/1", {"expected 1 to 8192 px, got 0"});
  check_fault(faults, "p.json:7:9: error: /dept", {"unknown parameter \"dept\", did you mean \"depth\"?"});
}

TEST_CASE("a list of numbers has as many as it should") {
  check_fault(faults_of(R"({"size_px":[640]})"), "", {"expected an array of 2, got an array of 1"});
}

TEST_CASE("a value from the command line is JSON, or else a string") {
  Parameters p(every_kind());
  CHECK(p.set(every_kind(), "size_px", "[440,540]").empty());
  CHECK(p.set(every_kind(), "delta_ms", "0.5").empty());
  CHECK(p.set(every_kind(), "mirror", "true").empty());
  CHECK(p.set(every_kind(), "kernel", "portable").empty());
  CHECK(p.set(every_kind(), "name", "2024").empty());
  CHECK(p.set(every_kind(), "file", "\"quoted.bin\"").empty());
  CHECK(p.numbers("size_px") == std::vector<double>{440, 540});
  CHECK(p.number("delta_ms") == 0.5);
  CHECK(p.flag("mirror"));
  CHECK(p.text("kernel") == "portable");
  CHECK(p.text("name") == "2024");
  CHECK(p.text("file") == "quoted.bin");
}

TEST_CASE("a wrong value from the command line is refused and changes nothing") {
  Parameters p(every_kind());
  CHECK(p.set(every_kind(), "delta_ms", "5000") == "expected 0 to 1000 ms, got 5000");
  CHECK(p.set(every_kind(), "delta_ms", "soon") == "expected a number, got \"soon\"");
  CHECK(p.set(every_kind(), "size_px", "[440,540") == "expected an array of 2, got \"[440,540\"");
  CHECK(p.number("delta_ms") == 10);
  CHECK(p.numbers("size_px") == std::vector<double>{4, 3});
}

TEST_CASE("bytes that are no text do not harm a value from the command line") {
  Parameters p(every_kind());
  CHECK(p.set(every_kind(), "name", "\xff\xfe").empty());
  CHECK_FALSE(p.set(every_kind(), "depth", std::string(5000, '[')).empty());
}

TEST_CASE("a link that knows no commands says so by its type") {
  const auto link = testing::fake_catalogue().make("sync");
  CHECK_THROWS_WITH(link->control("louder", {}), "a link of type \"sync\" knows no command \"louder\"");
}

TEST_CASE("a catalogue holds each link type once") {
  Catalogue catalogue = testing::fake_catalogue();
  const auto before = catalogue.link_types().size();
  CHECK_FALSE(catalogue.add([] { return testing::fake_catalogue().make("sync"); }));
  CHECK(catalogue.link_types().size() == before);
  CHECK(catalogue.make("nothing") == nullptr);
}

}  // namespace svchain
