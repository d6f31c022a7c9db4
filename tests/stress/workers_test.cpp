#include "framework/chain/workers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <numeric>
#include <stdexcept>

#include "tests/catch.h"
#include "tests/framework/fake_links.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

template <class F>
void run(Workers& workers, int count, const F& f) {
  workers.run(
      count, [](const void* context, int part) { (*static_cast<const F*>(context))(part); }, &f);
}

/// Squares every number that comes in, in ten parts; the frame carries their sum.
class Parted : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "parted";
    d.inputs = {{.name = "in", .types = {"number"}, .count = 1}};
    d.outputs = {{.name = "out", .types = {"number"}, .count = 1}};
    return d;
  }
  void configure(Configuration& c) override { c.output(0, {number_format()}); }
  void process(Call& call) override {
    const int64_t v = value_of(call.input(0));
    std::array<int64_t, 10> parts = {};
    const auto part = [&](int i) { parts[static_cast<size_t>(i)] = v * i; };
    call.parallel(10, part);
    send_number(call, 0, std::accumulate(parts.begin(), parts.end(), int64_t{0}));
  }
};

}  // namespace

TEST_CASE("every part of every round is done once, whoever does it") {
  for (const int helpers : {0, 1, 3}) {
    Workers workers(helpers);
    std::vector<int> times(100);
    for (int round = 1; round <= 300; ++round) {
      const int count = round % 100 + 1;
      std::fill(times.begin(), times.end(), 0);
      const auto part = [&](int i) { ++times[static_cast<size_t>(i)]; };
      run(workers, count, part);
      REQUIRE(std::count(times.begin(), times.end(), 1) == count);
      REQUIRE(std::accumulate(times.begin(), times.end(), 0) == count);
    }
  }
}

TEST_CASE("no parts at all are done at once") {
  Workers workers(2);
  const auto part = [](int) { throw std::logic_error("there is none"); };
  CHECK_NOTHROW(run(workers, 0, part));
}

TEST_CASE("what a part throws comes out after all parts are done, and the next round goes well") {
  Workers workers(3);
  for (int round = 0; round < 50; ++round) {
    std::atomic<int> done{0};
    const auto part = [&](int i) {
      ++done;
      if (i % 7 == 3) throw std::runtime_error("part of seven");
    };
    CHECK_THROWS_WITH(run(workers, 20, part), "part of seven");
    CHECK(done == 20);
    const auto quiet = [&](int) { ++done; };
    CHECK_NOTHROW(run(workers, 5, quiet));
    CHECK(done == 25);
  }
}

TEST_CASE("a link on a core of several CPUs makes what it makes on one") {
  for (const std::string cpus : {"1", "2", "4"}) {
    Fakes fakes;
    fakes.catalogue.add([] { return std::make_unique<Parted>(); });
    fakes.soc = R"({"name":"duo","cores":{"A":{"kind":"M4"},"B":{"kind":"C66x","cpus":)" + cpus + "}}}";
    std::promise<void> done;
    ChainOptions options;
    options.pace.frames = 500;
    options.on_finished = [&] { done.set_value(); };
    auto chain = fakes.chain(R"({"name":"parts","links":{
      "numbers":{"type":"numbers","core":"A"},"parted":{"type":"parted","core":"B"},
      "collect":{"type":"collect","core":"A"}},
      "edges":["numbers.out -> parted.in","parted.out -> collect.in"]})",
                             options);
    chain->start();
    done.get_future().wait();
    chain->stop();
    REQUIRE(fakes.seen.size() == 500);
    for (int64_t i = 0; i < 500; ++i) CHECK(fakes.seen[static_cast<size_t>(i)] == 45 * i);
  }
}
