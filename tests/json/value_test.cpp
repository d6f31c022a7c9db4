#include "algorithms/json/value.h"

#include "tests/catch.h"

using namespace svchain;
using json::Document;
using json::Value;

namespace {

/// A document with the faults that reading it leaves behind.
struct Reading {
  explicit Reading(const std::string& text) : document(*Document::parse(text, "a.json")) {}
  Value root() { return {document, faults}; }
  std::string only_fault() {
    REQUIRE(faults.size() == 1);
    return faults.front().text();
  }
  Document document;
  Faults faults;
};

}  // namespace

TEST_CASE("sound values are read without a fault") {
  Reading r("{\"n\":1.5,\"i\":-7,\"b\":true,\"s\":\"x\",\"c\":\"red\",\"v\":[1,2,3]}");
  CHECK(r.root().required("n").number() == 1.5);
  CHECK(r.root().required("i").integer() == -7);
  CHECK(r.root().required("b").boolean());
  CHECK(r.root().required("s").string() == "x");
  CHECK(r.root().required("c").choice({"red", "blue"}) == "red");
  CHECK(r.root().required("v").numbers(3) == std::vector<double>{1, 2, 3});
  CHECK(r.faults.empty());
}

TEST_CASE("a value of another kind is told with its place, what was expected and what came") {
  Reading r("{\n \"n\": \"five\"}");
  r.root().required("n").number();
  CHECK(r.only_fault() == "a.json:2:7: error: /n: expected a number, got \"five\"");
}

TEST_CASE("a number out of its range is told with the range") {
  Reading r("{\"n\": 11}");
  r.root().required("n").number({0, 10});
  CHECK(r.only_fault() == "a.json:1:7: error: /n: expected 0 to 10, got 11");
}

TEST_CASE("a missing key is told once, and its missing members are silent") {
  Reading r("{}");
  r.root().required("a").required("b").number();
  CHECK(r.only_fault() == "a.json:1:1: error: \"a\" is missing");
}

TEST_CASE("an absent optional value is silent and reads as its fallback") {
  Reading r("{}");
  CHECK(r.root().optional("n").number({}, 5) == 5);
  CHECK_FALSE(r.root().optional("n"));
  CHECK(r.faults.empty());
}

TEST_CASE("an unknown key is told with the nearest known one") {
  Reading r("{\"$schema\":\"x\",\"lenght_m\":1}");
  r.root().only({"length_m", "width_m"});
  CHECK(
      r.only_fault() ==
      "a.json:1:27: error: /lenght_m: unknown key, did you mean \"length_m\"? (known: length_m or width_m)");
}

TEST_CASE("an unknown word is told with the nearest choice") {
  Reading r("{\"c\":\"blu\"}");
  CHECK(r.root().required("c").choice({"red", "blue"}, "red") == "red");
  CHECK(r.only_fault() == "a.json:1:6: error: /c: expected red or blue, got \"blu\", did you mean \"blue\"?");
}

TEST_CASE("all faults of a document are found in one pass") {
  Reading r("{\"n\":\"x\",\"v\":[1,\"y\"],\"z\":0}");
  const auto root = r.root();
  root.only({"n", "v", "w"});
  root.required("n").number();
  root.required("v").numbers(2);
  root.required("w").boolean();
  CHECK(r.faults.size() == 4);
}

TEST_CASE("one mistake is told once however many getters meet it") {
  Reading r("{\"o\":3}");
  const auto o = r.root().required("o");
  o.only({"a", "b"});
  o.required("a").number();
  o.required("b").number();
  CHECK(r.only_fault() == "a.json:1:6: error: /o: expected an object, got 3");
}

TEST_CASE("an array of another length is told with both lengths") {
  Reading r("{\"v\":[1,2]}");
  CHECK(r.root().required("v").numbers(3) == std::vector<double>{0, 0, 0});
  CHECK(r.only_fault() == "a.json:1:6: error: /v: expected an array of 3, got an array of 2");
}

TEST_CASE("a whole number may be written as a float, a fraction may not stand for one") {
  Reading r("{\"a\":3.0,\"b\":3.5}");
  CHECK(r.root().required("a").integer() == 3);
  CHECK(r.faults.empty());
  r.root().required("b").integer();
  CHECK(r.only_fault().find("/b: expected a whole number, got 3.5") != std::string::npos);
}

TEST_CASE("whole numbers too large to hold are refused") {
  for (const char* number :
       {"18446744073709551615", "18446744073709551616", "-9223372036854775809", "1e300"}) {
    INFO(number);
    Reading r("{\"n\":" + std::string(number) + "}");
    CHECK(r.root().required("n").integer({}, 1) == 1);
    CHECK(r.faults.size() == 1);
  }
}

TEST_CASE("a fault shows a long value shortened") {
  Reading r("{\"n\":\"" + std::string(1000, 'x') + "\"}");
  r.root().required("n").number();
  CHECK(r.only_fault().size() < 120);
}

TEST_CASE("a word far from all names suggests none") {
  CHECK(did_you_mean("xylophone", {"front", "rear"}).empty());
  CHECK(did_you_mean("", {"front", "rear"}).empty());
  CHECK(did_you_mean("frnot", {"front", "rear"}) == ", did you mean \"front\"?");
}
