// "--trace" writes what a run did; "timeline" draws it.

#include <csignal>
#include <map>
#include <regex>
#include <set>

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

struct Setting {
  TemporaryFolder folder;
  fs::path rig = folder.path() / "rig.json";
  fs::path input = folder.path() / "input";
  fs::path trace = folder.path() / "trace.json";
  fs::path picture = folder.path() / "timeline.svg";

  Setting() {
    write_json(rig, small_rig());
    write_numbered(input, 10);
  }
  Outcome run(const Arguments& more = {}) const {
    Arguments all = {"--trace", trace};
    all.insert(all.end(), more.begin(), more.end());
    return svchain_program(small_run("2dsv_2dsp", rig, input, all));
  }
  Outcome draw(const Arguments& more = {}) const {
    Arguments all = {"timeline", trace, "--output", picture};
    all.insert(all.end(), more.begin(), more.end());
    return svchain_program(all);
  }
};

/// Phases of the events, and names of the slices.
std::map<std::string, std::set<std::string>> names_by_phase(const fs::path& trace) {
  std::map<std::string, std::set<std::string>> names;
  const Json whole = Json::parse(read_text(trace));
  for (const auto& event : whole["traceEvents"]) {
    names[event["ph"]].insert(event["name"]);
  }
  return names;
}

const std::vector<std::string> kLinks = {
    "capture", "sync", "dup", "geometric_alignment", "synthesis", "photometric_alignment", "display"};

/// Slices whose frame is delivered one millisecond after the other.
std::string long_trace(int frames) {
  std::string text = R"({"otherData":{"usecase":"x","soc":"y","delivering":["show"]},"traceEvents":[
    {"ph":"M","name":"thread_name","tid":1,"args":{"name":"core_one"}})";
  for (int i = 0; i < frames; ++i) {
    text += ",\n" + Json{{"ph", "X"},        {"name", "show"}, {"tid", 1},
                         {"ts", 1000.0 * i}, {"dur", 500},     {"args", {{"frame", i}}}}
                        .dump();
  }
  return text + "]}";
}

}  // namespace

TEST_CASE("the trace of a virtual run is the same on every run, byte by byte") {
  const Setting setting;
  const auto trace = [&] {
    const Outcome outcome = setting.run({"--clock", "virtual"});
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return read_text(setting.trace);
  };
  const std::string first = trace();
  fs::remove(setting.trace);
  CHECK(trace() == first);
  CHECK(Json::parse(first)["otherData"]["modelled"] == true);
}

TEST_CASE("a trace has slices of all links, arrows, queues and the cores' names, with threads too") {
  const Setting setting;
  const Outcome outcome = setting.run();
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  auto names = names_by_phase(setting.trace);
  CHECK(names["X"] == std::set<std::string>(kLinks.begin(), kLinks.end()));
  CHECK(names["s"] == names["f"]);
  CHECK(names["s"].count("dup.out1 -> synthesis.frames") == 1);
  CHECK(names["s"].count("sync.frames -> dup.in") == 0);  // within a core
  CHECK(names["C"].count("sync.frames -> dup.in") == 1);
  const std::string text = read_text(setting.trace);
  for (const char* core : {"A15", "IPU1", "DSP1", "DSP2"}) CHECK_THAT(text, Contains(core));
  CHECK(Json::parse(text)["otherData"]["modelled"] == false);
}

TEST_CASE("a trace that cannot be written is refused before the run, beside all other faults") {
  const Setting setting;
  const Outcome outcome = svchain_program(
      small_run("2dsv_2dsp", setting.rig, setting.input, {"--trace", "/nowhere/t.json", "--frames", "no"}));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--trace: error: \"/nowhere/t.json\" cannot be written") &&
                              Contains("--frames: error:"));
}

TEST_CASE("an interrupted run leaves its trace") {
  const Setting setting;
  const auto frames_went_by = [](const std::string& said) {
    return std::regex_search(said, std::regex("[1-9][0-9]* frames, "));
  };
  write_stills(setting.folder.path() / "stills");
  const Outcome outcome =
      svchain_interrupted(small_run("2dsv_2dsp", setting.rig, setting.folder.path() / "stills",
                                    {"--frames", "1000000000", "--trace", setting.trace}),
                          SIGINT, frames_went_by);
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(names_by_phase(setting.trace)["X"].count("display") == 1);
}

TEST_CASE("a timeline shows every core and every link") {
  const Setting setting;
  REQUIRE(setting.run().status == 0);
  const Outcome outcome = setting.draw({"--from", "0"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const std::string svg = read_text(setting.picture);
  CHECK_THAT(svg, Contains("<svg") && Contains("2dsv_2dsp on tda2x") && Contains("</svg>"));
  for (const char* core : {"A15", "IPU1", "DSP1", "DSP2"})
    CHECK_THAT(svg, Contains(">" + std::string(core) + "<"));
  for (const auto& link : kLinks) CHECK_THAT(svg, Contains(">" + link + "<"));
  CHECK_THAT(svg, Contains("<title>synthesis.view -&gt; display.frames</title>"));
}

TEST_CASE("a virtual run, in which all may happen at one moment, can be drawn too") {
  const Setting setting;
  REQUIRE(setting.run({"--clock", "virtual"}).status == 0);
  const Outcome outcome = setting.draw();
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK_THAT(read_text(setting.picture), Contains("modelled time"));
}

TEST_CASE("a long trace is drawn from its first delivered frame, and the picture says so") {
  const Setting setting;
  write_text(setting.trace, long_trace(100));
  REQUIRE(setting.draw().status == 0);
  CHECK_THAT(read_text(setting.picture),
             Contains("0.500 to 6.500 ms of 0.000 to 99.500 ms: the first 6 frames after"));
  REQUIRE(setting.draw({"--from", "20", "--to", "30.25"}).status == 0);
  const std::string svg = read_text(setting.picture);
  CHECK_THAT(svg, Contains("20.000 to 30.250 ms of") && Contains("show, frame 30") &&
                      !Contains("show, frame 31") && !Contains("show, frame 19"));
}

TEST_CASE("a bad part of a trace is refused") {
  const Setting setting;
  write_text(setting.trace, long_trace(10));
  const Outcome words = setting.draw({"--from", "soon", "--to", "-1"});
  CHECK(words.status == 2);
  CHECK_THAT(words.err, Contains("--from: error: expected a number") && Contains("--to: error:"));
  const Outcome backwards = setting.draw({"--from", "5", "--to", "4"});
  CHECK(backwards.status == 2);
  CHECK_THAT(backwards.err, Contains("--from: error: expected a beginning before the end"));
  CHECK_FALSE(fs::exists(setting.picture));
}

TEST_CASE("every fault of a bad trace is told at once, with its place") {
  const Setting setting;
  write_text(setting.trace, R"({"traceEvents":[
{"ph":"M","name":"thread_name","tid":1,"args":{"name":"A"}},
{"ph":"X","name":"add","tid":1,"ts":0},
{"ph":"X","name":"add","tid":2,"ts":"now","dur":1},
{"ph":"s","name":"a.b -> c.d","tid":1,"ts":0,"id":7},
{"ph":"f","name":"a.b -> c.d","tid":1,"ts":0,"id":8},
{"name":"nothing"},
17]})");
  const Outcome outcome = setting.draw();
  CHECK(outcome.status == 2);
  for (const char* said :
       {"trace.json:3:1: error: /traceEvents/1", "missing", "trace.json:4:", "/traceEvents/2/ts",
        "no \"thread_name\" event names this track", "/traceEvents/3", "never ends", "/traceEvents/4/id",
        "has no beginning", "/traceEvents/5", "/traceEvents/6"}) {
    CHECK_THAT(outcome.err, Contains(said));
  }
  CHECK_FALSE(fs::exists(setting.picture));
}

TEST_CASE("what is no trace, or an empty one, is told from one that can be drawn") {
  const Setting setting;
  write_text(setting.trace, "no JSON");
  CHECK(setting.draw().status == 2);
  write_text(setting.trace, R"({"links":{}})");
  const Outcome other = setting.draw();
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("traceEvents"));
  write_text(setting.trace, R"({"traceEvents":[]})");
  const Outcome empty = setting.draw();
  CHECK(empty.status == 2);
  CHECK_THAT(empty.err, Contains("there is nothing to draw"));
  fs::remove(setting.trace);
  CHECK_THAT(setting.draw().err, Contains("trace.json"));
}
