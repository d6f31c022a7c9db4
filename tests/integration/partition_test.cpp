// The same links on other cores give the same pictures.

#include <algorithm>
#include <map>
#include <set>

#include "framework/chain/run.h"
#include "framework/link/call.h"
#include "framework/link/wrapped_link.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

uint64_t accounted(const nlohmann::json& report) {
  uint64_t sum = report["frames"]["delivered"].get<uint64_t>();
  for (const auto& [reason, count] : report["frames"]["dropped"].items()) sum += count.get<uint64_t>();
  return sum;
}

void require_all_home(const nlohmann::json& report) {
  for (const auto& [name, pool] : report["pools"].items()) {
    INFO(name);
    CHECK(pool["outstanding_at_stop"] == 0);
  }
}

/// Where in memory a link finds what it is given: by sequence, the addresses of all buffers at a port.
using Addresses = std::map<uint64_t, std::vector<const std::byte*>>;

class AddressReader final : public WrappedLink {
 public:
  AddressReader(std::unique_ptr<Link> link, int port, Addresses& addresses)
      : WrappedLink(std::move(link)), port_(port), addresses_(addresses) {}
  void process(Call& call) override {
    const Frame& frame = call.input(port_);
    for (int i = 0; frame && i < frame.count(); ++i)
      addresses_[frame.sequence()].push_back(frame.bytes(i).data());
    link().process(call);
  }

 private:
  int port_;
  Addresses& addresses_;
};

void read_addresses(Plan& plan, const std::string& link_name, const std::string& port, Addresses& addresses) {
  for (PlannedLink& link : plan.links) {
    if (link.entry.name != link_name) continue;
    const auto inputs = link.link->describe().inputs;
    const auto at = std::find_if(inputs.begin(), inputs.end(), [&](const auto& i) { return i.name == port; });
    REQUIRE(at != inputs.end());
    link.link = std::make_unique<AddressReader>(std::move(link.link), int(at - inputs.begin()), addresses);
    return;
  }
  FAIL("no link " << link_name);
}

}  // namespace

TEST_CASE("frames are handed on, never copied: every link finds a camera's frame at the same address") {
  const SurroundView world;
  for (const std::string use_case : {"2dsv_1dsp", "2dsv_2dsp"}) {
    Plan plan = world.plan(use_case);
    Addresses taken, duplicated, aligned, synthesised, shown;
    read_addresses(plan, "sync", "rear", taken);
    read_addresses(plan, "dup", "in", duplicated);
    read_addresses(plan, "geometric_alignment", "frames", aligned);
    read_addresses(plan, "synthesis", "frames", synthesised);
    read_addresses(plan, "display", "frames", shown);
    const auto report = world.run(std::move(plan), 6);
    REQUIRE(synthesised.size() == 6);
    CHECK(duplicated == synthesised);
    for (const auto& [sequence, addresses] : synthesised) {
      REQUIRE(addresses.size() == 4);
      CHECK(taken.at(sequence).at(0) == addresses[2]);
      if (aligned.count(sequence)) CHECK(aligned[sequence] == addresses);
    }
    // The composite: never anywhere but in the buffers that synthesis writes.
    std::set<const std::byte*> places;
    for (const auto& [sequence, addresses] : shown) places.insert(addresses.begin(), addresses.end());
    CHECK(shown.size() == 6);
    CHECK(places.size() <= report["pools"]["synthesis.view"]["buffers"].get<size_t>());
  }
}

TEST_CASE(
    "both partitions deliver every frame and the same pixels, on every SoC that has the cores, in any "
    "order") {
  const SurroundView world;
  const auto expected = world.run(world.plan("2dsv_2dsp"), 8);
  CHECK(expected["frames"] ==
        nlohmann::json{{"captured", 8}, {"delivered", 8}, {"dropped", nlohmann::json::object()}});
  require_all_home(expected);
  const auto sha = expected["output"]["sha256"].get<std::string>();
  CHECK(world.run(world.plan("2dsv_1dsp"), 8)["output"]["sha256"] == sha);
  CHECK(world.run(world.plan("2dsv_1dsp", "tda2eco"), 8)["output"]["sha256"] == sha);
  CHECK(world.run(world.plan("2dsv_2dsp", "tda3x"), 8)["output"]["sha256"] == sha);
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    const auto report = world.run(world.plan("2dsv_2dsp"), 8, seed);
    CHECK(report["output"]["sha256"] == sha);
    require_all_home(report);
  }
}

TEST_CASE("the partition decides which edges are IPC pairs") {
  const SurroundView world;
  const auto two = world.run(world.plan("2dsv_2dsp"), 2)["edges"];
  const auto one = world.run(world.plan("2dsv_1dsp"), 2)["edges"];
  CHECK(two["geometric_alignment.lut -> synthesis.lut"]["ipc"] == true);
  CHECK(one["geometric_alignment.lut -> synthesis.lut"]["ipc"] == false);
  CHECK(two["dup.out1 -> synthesis.frames"]["ipc"] == true);
  CHECK(one["sync.frames -> dup.in"]["ipc"] == false);
}

TEST_CASE("the tone mapping of a frame comes from the frame before: the second differs from the first") {
  const SurroundView world;
  const auto curves = [&](uint64_t frames) {
    return world.run(world.plan("2dsv_2dsp"), frames)["photometric"]["tone_mapping"]["front"]["b"]
        .get<std::vector<int>>();
  };
  std::vector<int> identity(256);
  for (int v = 0; v < 256; ++v) identity[static_cast<size_t>(v)] = v;
  CHECK(curves(1) == identity);
  CHECK(curves(2) != identity);
}

TEST_CASE("the display on host is A15, or IPU1 where there is no A15") {
  const SurroundView world;
  CHECK(world.run(world.plan("2dsv_2dsp"), 1)["links"]["display"]["core"] == "A15");
  CHECK(world.run(world.plan("2dsv_2dsp", "tda3x"), 1)["links"]["display"]["core"] == "IPU1");
}

TEST_CASE("a SoC without the core refuses the use case and says which cores it has") {
  const SurroundView world;
  CHECK_THROWS_WITH(world.plan("2dsv_2dsp", "tda2eco"),
                    Catch::Matchers::Contains("DSP2") && Catch::Matchers::Contains("DSP1"));
}

TEST_CASE("a link that throws stops the chain, or costs its frame, as the use case says") {
  const SurroundView world;
  for (const std::string on_error : {"stop", "drop"}) {
    auto text = SurroundView::with_camera_fault("2dsv_2dsp", "front", nlohmann::json::object());
    text["links"]["thrower"] = {
        {"type", "thrower"}, {"core", "EVE1"}, {"params", {{"at", 4}}}, {"on_error", on_error}};
    for (auto& edge : text["edges"]) {
      if (edge.is_object() && edge["from"] == "synthesis.view") edge["to"] = "thrower.in";
    }
    text["edges"].push_back("thrower.out -> display.frames");
    const auto report = world.run(world.plan(text.dump()), 8);
    require_all_home(report);
    CHECK(accounted(report) == report["frames"]["captured"]);
    if (on_error == "stop") {
      CHECK(report["failure"] == "EVE1/thrower: frame 4: the hood is open");
      CHECK(report["frames"]["delivered"] == 4);
    } else {
      CHECK_FALSE(report.contains("failure"));
      CHECK(report["frames"]["delivered"] == 7);
      CHECK(report["frames"]["dropped"] == nlohmann::json{{"error", 1}});
    }
  }
}

TEST_CASE("a chain that is stopped anywhere delivers what it has captured") {
  const SurroundView world;
  for (const int steps : {0, 1, 2, 3, 5, 8, 13, 21, 34}) {
    Chain chain(world.plan("2dsv_2dsp"), by_hand_options(100));
    REQUIRE(chain.configure());
    chain.start();
    for (int i = 0; i < steps; ++i) chain.step() || chain.advance_clock();
    chain.stop();
    const auto report = chain.report();
    CHECK(report["frames"]["captured"] == report["frames"]["delivered"]);
    require_all_home(report);
  }
}

TEST_CASE("once a run has started, frames pass without a single allocation") {
  const SurroundView world;
  Chain chain(world.plan("2dsv_2dsp", "tda2x", {"display.sha256=false"}), by_hand_options(30));
  REQUIRE(chain.configure());
  chain.start();
  const auto processed = [&] { return chain.calls(); };
  while (processed() < 60)
    chain.step() || chain.advance_clock();  // all links have been called, the LUT is made
  const size_t before = allocation_count();
  for (int i = 0; i < 100; ++i) chain.step() || chain.advance_clock();
  CHECK(allocation_count() == before);
  chain.stop();
  CHECK(chain.report()["frames"]["delivered"] == chain.report()["frames"]["captured"]);
}
