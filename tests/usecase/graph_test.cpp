#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/usecase/plan.h"
#include "tests/catch.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"

namespace svchain {

namespace {

Plan two_dsps() {
  auto plan = testing::plan_of(testing::kTwoDsps);
  REQUIRE(plan);
  return std::move(*plan);
}

size_t count(const std::string& text, const std::string& word) {
  size_t n = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
  return n;
}

}  // namespace

TEST_CASE("the graph as JSON has an IPC pair for every edge between cores") {
  const auto graph = nlohmann::json::parse(graph_json(two_dsps()));
  CHECK(graph["usecase"] == "2dsv_2dsp");
  CHECK(graph["cores"].size() == 4);
  const size_t crossing = 6, links = 7, edges = 11;
  CHECK(graph["nodes"].size() == links + 2 * crossing);
  CHECK(graph["edges"].size() == edges + 2 * crossing);
  size_t ipc = 0;
  for (const auto& edge : graph["edges"]) ipc += edge["ipc"].get<bool>();
  CHECK(ipc == crossing);
}

TEST_CASE("the ends of an IPC pair stand on the cores that they join") {
  const auto graph = nlohmann::json::parse(graph_json(two_dsps()));
  std::map<std::string, std::string> core_of;
  for (const auto& node : graph["nodes"]) core_of[node["id"]] = node["core"];
  CHECK(core_of.at("dup.out1.ipc_out") == "IPU1");
  CHECK(core_of.at("synthesis.frames.ipc_in") == "DSP2");
  for (const auto& edge : graph["edges"]) {
    CHECK((core_of.at(edge["from"]) != core_of.at(edge["to"])) == edge["ipc"].get<bool>());
  }
}

TEST_CASE("the graph for dot names every link and marks the feedback") {
  const std::string dot = graph_dot(two_dsps());
  for (const char* name : {"\"capture\"", "\"sync\"", "\"dup\"", "\"geometric_alignment\"", "\"synthesis\"",
                           "\"photometric_alignment\"", "\"display\""}) {
    CHECK(count(dot, std::string(name) + " [label=") == 1);
  }
  CHECK(count(dot, "subgraph \"cluster_") == 4);
  CHECK(count(dot, "style=dashed") == 3);
}

TEST_CASE("the picture shows every link, core, edge and IPC end") {
  const std::string svg = graph_svg(two_dsps());
  for (const char* name : {">capture<", ">photometric_alignment<", ">A15<", ">DSP2<", ">2dsv_2dsp<"}) {
    CHECK(count(svg, name) == 1);
  }
  CHECK(count(svg, "<title>") == 11);
  CHECK(count(svg, ">IPC out<") == 6);
  CHECK(count(svg, ">IPC in<") == 6);
  CHECK(count(svg, "nan") == 0);
}

TEST_CASE("names in the picture cannot break it") {
  auto plan = testing::plan_of(R"({"name": "<&\">", "links": {"c": {"type": "capture", "core": "IPU1"},
    "n": {"type": "null", "core": "IPU1"}}, "edges": ["c.front -> n.in"]})");
  REQUIRE(plan);
  CHECK(count(graph_svg(*plan), "&lt;&amp;&quot;&gt;") == 1);
  CHECK(count(graph_dot(*plan), "digraph \"<&\\\">\"") == 1);
}

TEST_CASE("the picture is wellformed XML") {
  if (std::system("python3 -c 'import xml.dom.minidom' 2>/dev/null") != 0) {
    WARN("skipped: python3 is not here");
    return;
  }
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / "graph.svg").string();
  std::ofstream(path) << graph_svg(two_dsps());
  CHECK(std::system(("python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' " + path)
                        .c_str()) == 0);
}

}  // namespace svchain
