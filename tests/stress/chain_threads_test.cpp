#include <future>

#include "tests/catch.h"
#include "tests/framework/fake_links.h"
#include "tests/framework/trace_check.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

/// Runs with threads until the chain has finished by itself.
void run_with_threads(Chain& chain, std::future<void> finished) {
  chain.start();
  finished.wait();
  chain.stop();
}

struct Threaded {
  Threaded() {
    options.on_finished = [this] { done.set_value(); };
  }
  ChainOptions options;
  std::promise<void> done;
};

}  // namespace

TEST_CASE("threads deliver what one thread delivers, with feedback exact across cores") {
  for (const std::string core : {"A", "B"}) {
    for (const std::string bell : {R"("spins":0)", R"("spins":200)", R"("parks":false)"}) {
      Fakes fakes;
      Threaded threaded;
      fakes.soc = R"({"name":"duo","cores":{"A":{"kind":"M4",)" + bell + R"(},"B":{"kind":"C66x"}}})";
      threaded.options.pace.frames = 2000;
      auto chain = fakes.chain(loop(core), threaded.options);
      run_with_threads(*chain, threaded.done.get_future());
      REQUIRE(fakes.seen.size() == 2000);
      bool exact = true;
      for (int64_t i = 1; i < 2000; ++i)
        exact = exact && fakes.seen[static_cast<size_t>(i)] == 1000 * i + i - 1 + 500;
      CHECK(exact);
      CHECK(chain->outstanding().empty());
    }
  }
}

TEST_CASE("a chain of threads can be stopped at any time and brings every buffer home") {
  for (int i = 0; i < 50; ++i) {
    Fakes fakes;
    ChainOptions options;
    options.pace.frames = 1'000'000;
    auto chain = fakes.chain(loop(i % 2 ? "A" : "B"), options);
    chain->start();
    while (chain->calls() < static_cast<uint64_t>(37 * i)) std::this_thread::yield();
    chain->stop();
    CHECK(chain->outstanding().empty());
    const auto frames = chain->report()["frames"];
    CHECK(frames["captured"] == frames["delivered"]);
  }
}

TEST_CASE("an edge that drops, between threads, accounts for every frame") {
  for (const std::string policy : {"drop_oldest", "drop_newest", "latest"}) {
    Fakes fakes;
    Threaded threaded;
    threaded.options.pace.frames = 20'000;
    auto chain = fakes.chain(
        line("{}", "", R"({"from":"numbers.out","to":"add.in","depth":2,"policy":")" + policy + "\"}"),
        threaded.options);
    run_with_threads(*chain, threaded.done.get_future());
    const auto frames = chain->report()["frames"];
    uint64_t accounted = frames["delivered"].get<uint64_t>();
    for (const auto& [reason, count] : frames["dropped"].items()) accounted += count.get<uint64_t>();
    CHECK(accounted == 20'000);
    CHECK(chain->outstanding().empty());
    CHECK(std::is_sorted(fakes.seen.begin(), fakes.seen.end()));
  }
}

TEST_CASE("traced threads record every call and every frame between cores") {
  for (const char* tail : {"A", "B"}) {
    Fakes fakes;
    Threaded threaded;
    threaded.options.pace.frames = 2000;
    threaded.options.trace_events = 100'000;
    auto chain = fakes.chain(loop(tail), threaded.options);
    run_with_threads(*chain, threaded.done.get_future());
    const TraceCheck check(*chain);
    check_calls(check, *chain);
    CHECK(check.arrows.at("numbers.out -> loop.in") == 2000);
    CHECK(check.arrows.at("loop.out -> collect.in") == 2000);
  }
}

TEST_CASE("traced threads record what edges between them drop, full recorders or not") {
  for (const std::string policy : {"drop_oldest", "drop_newest", "latest"}) {
    for (const size_t events : {1'000, 200'000}) {
      Fakes fakes;
      Threaded threaded;
      threaded.options.pace.frames = 5'000;
      threaded.options.trace_events = events;
      auto chain = fakes.chain(
          line("{}", "", R"({"from":"numbers.out","to":"add.in","depth":2,"policy":")" + policy + "\"}"),
          threaded.options);
      run_with_threads(*chain, threaded.done.get_future());
      const TraceCheck check(*chain);
      const bool full = check.trace["otherData"]["lost_events"] > 0;
      CHECK(full == (events == 1'000));
      if (full) continue;
      check_calls(check, *chain);
      CHECK(check.arrows.at("add.out -> collect.in") == fakes.seen.size());
    }
  }
}

TEST_CASE("commands reach a running chain") {
  Fakes fakes;
  ChainOptions options;
  options.pace.frames = 100'000'000;
  auto chain = fakes.chain(line(), options);
  chain->start();
  for (int plus = 1; plus <= 20; ++plus) CHECK(chain->control("add", "plus", plus).get()["plus"] == plus);
  chain->stop();
  CHECK(chain->outstanding().empty());
}

TEST_CASE("a failing link ends a chain of threads") {
  Fakes fakes;
  Threaded threaded;
  threaded.options.pace.frames = 1000;
  auto chain = fakes.chain(line(R"({"throw_at":500})"), threaded.options);
  run_with_threads(*chain, threaded.done.get_future());
  REQUIRE(chain->failure());
  CHECK(chain->failure()->sequence == 500);
  CHECK(fakes.seen.size() == 500);
  CHECK(chain->outstanding().empty());
}

TEST_CASE("chains of threads come and go") {
  for (int i = 0; i < 100; ++i) {
    Fakes fakes;
    Threaded threaded;
    auto chain = fakes.chain(line(), threaded.options);
    run_with_threads(*chain, threaded.done.get_future());
    CHECK(fakes.seen.size() == 10);
  }
}
