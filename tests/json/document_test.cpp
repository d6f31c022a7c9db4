#include "algorithms/json/document.h"

#include <fstream>

#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using json::Document;

namespace {

std::string only_fault(const std::string& text) {
  const auto document = Document::parse(text, "a.json");
  REQUIRE_FALSE(document);
  REQUIRE(document.error().size() == 1);
  return document.error().front().text();
}

Location place(const std::string& text, const std::string& pointer) {
  const auto document = Document::parse(text, "a.json");
  REQUIRE(document);
  return document->locate(pointer);
}

bool at(Location where, int line, int column) {
  return where.line == line && where.column == column;
}

}  // namespace

TEST_CASE("a value is located where its first character stands") {
  const std::string text = "{\"a\": 1,\n  \"b\" : [10,-2.5e3, true,\n\tnull],\"c\":{\"d\":\"x,y\"} }";
  CHECK(at(place(text, ""), 1, 1));
  CHECK(at(place(text, "/a"), 1, 7));
  CHECK(at(place(text, "/b"), 2, 9));
  CHECK(at(place(text, "/b/0"), 2, 10));
  CHECK(at(place(text, "/b/1"), 2, 13));
  CHECK(at(place(text, "/b/2"), 2, 21));
  CHECK(at(place(text, "/b/3"), 3, 2));
  CHECK(at(place(text, "/c/d"), 3, 17));
}

TEST_CASE("what does not exist is located at its nearest known parent") {
  CHECK(at(place("{\"a\":\n {\"b\":1}}", "/a/z/y"), 2, 2));
}

TEST_CASE("a number at the end of the text is located at its beginning") {
  CHECK(at(place("\n  42", ""), 2, 3));
}

TEST_CASE("a byte order mark shifts no column") {
  CHECK(at(place("\xEF\xBB\xBF{\"a\":1}", "/a"), 1, 6));
}

TEST_CASE("slashes and tildes in keys are escaped in pointers") {
  CHECK(at(place("{\"a/b~c\":7}", "/a~1b~0c"), 1, 10));
}

TEST_CASE("a key that stands twice is a fault at its second place") {
  const auto fault = only_fault("{\"a\":{\"b\":1,\n \"b\":2}}");
  CHECK(fault == "a.json:2:2: error: /a/b: this key stands twice in its object");
}

TEST_CASE("the same key in sibling objects is no fault") {
  CHECK(Document::parse("[{\"a\":1},{\"a\":2}]", "a.json"));
}

TEST_CASE("NaN, infinities and numbers too large for a double are refused") {
  for (const char* text : {"{\"a\":NaN}", "{\"a\":-Infinity}", "{\"a\":nan}", "{\"a\":1e999}"}) {
    INFO(text);
    CHECK_FALSE(Document::parse(text, "a.json"));
  }
}

TEST_CASE("comments and trailing commas are refused") {
  CHECK_FALSE(Document::parse("{\"a\":1 /* no */}", "a.json"));
  CHECK_FALSE(Document::parse("[1,2,]", "a.json"));
}

TEST_CASE("a truncated text is a fault at its end") {
  CHECK(only_fault("{\"a\":\n [1, 2").find("a.json:2:6: error: not valid JSON") == 0);
  CHECK(only_fault("{\"a\":\"x").find("a.json:1:7: error: not valid JSON") == 0);
  CHECK(only_fault("").find("not valid JSON") != std::string::npos);
}

TEST_CASE("text after the document is a fault") {
  CHECK_FALSE(Document::parse("{} {}", "a.json"));
}

TEST_CASE("bytes that are no UTF-8 are a fault") {
  CHECK_FALSE(Document::parse("{\"a\":\"\xFF\xFE\"}", "a.json"));
}

TEST_CASE("ten thousand levels of nesting are refused") {
  const std::string deep(10000, '[');
  CHECK(only_fault(deep) == "a.json:1:65: error: nested deeper than 64 levels");
  std::string objects;
  for (int i = 0; i < 10000; ++i) objects += "{\"a\":";
  CHECK(only_fault(objects).find("nested deeper than 64 levels") != std::string::npos);
}

TEST_CASE("64 levels of nesting are accepted") {
  CHECK(Document::parse(std::string(64, '[') + std::string(64, ']'), "a.json"));
}

TEST_CASE("a file that does not exist is named") {
  const auto document = Document::read("/nowhere/a.json");
  REQUIRE_FALSE(document);
  CHECK(document.error().front().text().find("/nowhere/a.json: error: cannot be read") == 0);
}

TEST_CASE("a folder in place of a file is refused") {
  const testing::TemporaryFolder folder;
  CHECK_FALSE(Document::read(folder.path()));
}

TEST_CASE("a document read from a file knows its folder") {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "a.json") << "{}";
  const auto document = Document::read(folder.path() / "a.json");
  REQUIRE(document);
  CHECK(document->folder() == folder.path());
}
