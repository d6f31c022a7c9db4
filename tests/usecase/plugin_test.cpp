#include "framework/link/plugin.h"

#include <fstream>

#include "tests/catch.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"

namespace svchain {

using testing::check_fault;

namespace {

Faults faults_of(const std::filesystem::path& path) {
  Catalogue catalogue;
  const auto plugin = load_plugin(path, catalogue);
  REQUIRE_FALSE(plugin);
  CHECK(catalogue.link_types().empty());
  return plugin.error();
}

}  // namespace

TEST_CASE("a plug-in adds its link to the catalogue") {
  Catalogue catalogue;
  const auto plugin = load_plugin(TEST_PLUGIN_BRIGHTEN, catalogue);
  if (!plugin) FAIL(plugin.error().front().text());
  CHECK(plugin->type == "brighten");
  CHECK(catalogue.link_types() == std::vector<std::string>{"brighten"});
  const auto link = catalogue.make("brighten");
  CHECK(link->describe().parameters.front().name == "by");
}

TEST_CASE("a plug-in stays loaded as long as its factory lives") {
  Catalogue catalogue;
  { REQUIRE(load_plugin(TEST_PLUGIN_BRIGHTEN, catalogue)); }
  CHECK(catalogue.make("brighten")->describe().help == "adds a little");
}

TEST_CASE("a plug-in whose link type is taken is refused") {
  Catalogue catalogue;
  REQUIRE(load_plugin(TEST_PLUGIN_BRIGHTEN, catalogue));
  const auto again = load_plugin(TEST_PLUGIN_BRIGHTEN, catalogue);
  REQUIRE_FALSE(again);
  check_fault(again.error(), TEST_PLUGIN_BRIGHTEN ": error", {"its link type \"brighten\" is taken already"});
}

TEST_CASE("a plug-in from another build is refused and both builds are named") {
  check_fault(
      faults_of(TEST_PLUGIN_OTHER_BUILD), TEST_PLUGIN_OTHER_BUILD ": error",
      {"is from another build", "\"svchain 99.0.0, ", "this program with \"svchain " SVCHAIN_VERSION ", "});
}

TEST_CASE("a library without the entry is refused") {
  check_fault(faults_of(TEST_PLUGIN_NO_PLUGIN), TEST_PLUGIN_NO_PLUGIN ": error", {"SVCHAIN_PLUGIN(Class)"});
}

TEST_CASE("a file that is no library, and one that is not there, are refused") {
  const testing::TemporaryFolder folder;
  const auto text = folder.path() / "text.so";
  std::ofstream(text) << "no library";
  check_fault(faults_of(text), text.string() + ": error", {"cannot be loaded as a shared library"});
  check_fault(faults_of(folder.path() / "none.so"), (folder.path() / "none.so").string() + ": error",
              {"there is no such file"});
}

}  // namespace svchain
