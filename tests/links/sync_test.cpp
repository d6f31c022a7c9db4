#include "links/sync/sync.h"

#include <initializer_list>

#include "framework/testing/harness.h"
#include "links/sync/set_ledger.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

constexpr int64_t kMs = 1'000'000;
constexpr int64_t kPeriod = 33 * kMs;
const char* const kNames[] = {"front", "right", "rear", "left"};

/// A sync alone; frames are told apart by their time stamps.
class SyncAlone {
 public:
  explicit SyncAlone(const std::string& missing = "repeat", int queue = 10) : harness(make_sync()) {
    harness.parameter("missing", missing);
    harness.parameter("queue", queue);
    for (const char* name : kNames) harness.input(name, {Format::bgr8(2, 2)});
    REQUIRE(harness.configure().empty());
  }

  void push(int camera, uint64_t n, int64_t time_ns) {
    harness.push(kNames[camera], {.sequence = n, .timestamp_ns = time_ns, .captured_ns = time_ns});
  }
  /// Set n of the cameras, at its nominal time.
  void push_set(uint64_t n, std::initializer_list<int> cameras = {0, 1, 2, 3}) {
    for (const int camera : cameras) push(camera, n, static_cast<int64_t>(n) * kPeriod);
  }
  void end() {
    for (const char* name : kNames) harness.push_end(name);
    harness.run();
  }
  std::optional<Frame> next() {
    harness.run();
    return harness.pop("frames");
  }
  uint64_t sets() {
    uint64_t count = 0;
    while (next()) ++count;
    return count;
  }
  uint64_t dropped_sets() { return harness.dropped()["sync_incomplete"]; }
  uint64_t dropped(int camera, const char* reason) {
    return harness.report()["links"]["sync"]["dropped_frames"][kNames[camera]][reason];
  }

  LinkHarness harness;
};

}  // namespace

TEST_CASE("four frames of the same moment become a set") {
  SyncAlone sync;
  sync.push(0, 7, 100 * kMs);
  sync.push(1, 7, 104 * kMs);
  sync.push(2, 7, 96 * kMs);
  CHECK(!sync.next());
  sync.push(3, 7, 101 * kMs);
  const auto set = sync.next();
  REQUIRE(set);
  CHECK(set->count() == 4);
  CHECK(set->sequence() == 7);
  CHECK(set->captured_ns() == 96 * kMs);
  CHECK(set->timestamp_ns(0) == 100 * kMs);
  CHECK(set->timestamp_ns(1) == 104 * kMs);
  CHECK(set->timestamp_ns(2) == 96 * kMs);
  CHECK(set->timestamp_ns(3) == 101 * kMs);
}

TEST_CASE("the order in which cameras arrive makes no difference to the sets") {
  SyncAlone sync;
  for (int camera : {3, 1, 0, 2}) {
    for (uint64_t n = 0; n < 2; ++n) sync.push(camera, n, static_cast<int64_t>(n) * kPeriod + camera * kMs);
  }
  for (uint64_t n = 0; n < 2; ++n) {
    const auto set = sync.next();
    REQUIRE(set);
    CHECK(set->sequence() == n);
    for (int camera = 0; camera < 4; ++camera) {
      CHECK(set->timestamp_ns(camera) == static_cast<int64_t>(n) * kPeriod + camera * kMs);
    }
  }
}

TEST_CASE("a frame that one camera has lost is replaced by its last one") {
  SyncAlone sync;
  sync.push_set(0);
  sync.push_set(1, {0, 1, 3});
  sync.push_set(2);
  REQUIRE(sync.next());
  const auto set = sync.next();
  REQUIRE(set);
  CHECK(set->sequence() == 1);
  CHECK(set->timestamp_ns(1) == kPeriod);
  CHECK(set->timestamp_ns(2) == 0);
  CHECK(sync.next()->timestamp_ns(2) == 2 * kPeriod);
  CHECK(sync.dropped_sets() == 0);
  CHECK(sync.harness.report()["links"]["sync"]["repeated_frames"]["rear"] == 1);
}

TEST_CASE("with skip a set that one camera has lost is dropped and counted") {
  SyncAlone sync("skip");
  sync.push_set(0);
  sync.push_set(1, {0, 1, 3});
  sync.push_set(2);
  CHECK(sync.next()->sequence() == 0);
  CHECK(sync.next()->sequence() == 2);
  CHECK(sync.dropped_sets() == 1);
  CHECK(sync.dropped(0, "incomplete_set") == 1);
  CHECK(sync.dropped(2, "incomplete_set") == 0);
}

TEST_CASE("a camera that is gone is repeated and keeps nobody waiting") {
  SyncAlone sync;
  sync.push_set(0);
  uint64_t sets = sync.sets();
  for (uint64_t n = 1; n <= 20; ++n) {
    sync.push_set(n, {0, 1, 2});
    sets += sync.sets();
  }
  CHECK(sets == 21);
  sync.push_set(21);
  const auto set = sync.next();
  REQUIRE(set);
  CHECK(set->timestamp_ns(0) == 21 * kPeriod);
}

TEST_CASE("a camera that was gone and always comes last is waited for again once it is back") {
  SyncAlone sync;
  for (uint64_t n = 0; n < 10; ++n) {
    sync.push_set(n, {0, 1, 2});
    sync.sets();
  }
  int64_t newest_left = 0;
  for (uint64_t n = 10; n < 20; ++n) {
    sync.push_set(n, {0, 1, 2});
    while (const auto set = sync.next()) newest_left = set->has(3) ? set->timestamp_ns(3) : 0;
    sync.push_set(n, {3});
    while (const auto set = sync.next()) newest_left = set->has(3) ? set->timestamp_ns(3) : 0;
  }
  CHECK(newest_left == 19 * kPeriod);
}

TEST_CASE("a camera that never came leaves its place empty") {
  SyncAlone sync;
  for (uint64_t n = 0; n < 10; ++n) sync.push_set(n, {0, 2, 3});
  const auto set = sync.next();
  REQUIRE(set);
  CHECK(set->count() == 4);
  CHECK(set->sequence() == 0);
  CHECK(set->has(0));
  CHECK(!set->has(1));
  CHECK(sync.sets() == 9);
}

TEST_CASE("with skip nothing comes while a camera is gone, and all of it is counted") {
  SyncAlone sync("skip");
  for (uint64_t n = 0; n < 12; ++n) sync.push_set(n, {0, 1, 2});
  CHECK(sync.sets() == 0);
  for (uint64_t n = 12; n < 15; ++n) sync.push_set(n);
  sync.harness.run();
  sync.end();
  const uint64_t sets = sync.sets();
  CHECK(sets == 3);
  CHECK(sync.dropped_sets() == 12);
}

TEST_CASE("one wild time stamp costs one frame of one camera, no more") {
  const int64_t wild = GENERATE(int64_t{1} << 50, -(int64_t{1} << 50), 5 * kMs * 1000);
  SyncAlone sync;
  for (uint64_t n = 0; n < 6; ++n) {
    sync.push_set(n, {0, 1, 3});
    sync.push(2, n, n == 2 ? wild : static_cast<int64_t>(n) * kPeriod);
    sync.harness.run();
  }
  sync.end();
  uint64_t n = 0;
  while (const auto set = sync.next()) {
    CHECK(set->sequence() == n);
    if (n != 2) CHECK(set->timestamp_ns(2) == static_cast<int64_t>(n) * kPeriod);
    ++n;
  }
  CHECK(n == 6);
  CHECK(sync.dropped(2, "wild_timestamp") == 1);
}

TEST_CASE("a camera whose clock stays wrong goes on showing its newest frames") {
  SyncAlone sync;
  uint64_t sets = 0;
  int64_t newest = 0;
  for (uint64_t n = 0; n < 12; ++n) {
    sync.push_set(n, {0, 1, 2});
    sync.push(3, n, static_cast<int64_t>(n) * kPeriod + 3600'000 * kMs);
    while (const auto set = sync.next()) {
      ++sets;
      newest = set->has(3) ? set->timestamp_ns(3) : 0;
    }
  }
  sync.end();
  while (sync.next()) ++sets;
  CHECK(sets == 12);
  CHECK(newest >= 3600'000 * kMs + 9 * kPeriod);
}

TEST_CASE("the same time stamp twice is one frame") {
  SyncAlone sync;
  sync.push_set(0);
  sync.push(1, 0, 0);
  sync.push_set(1);
  CHECK(sync.sets() == 2);
  CHECK(sync.dropped(1, "duplicate") == 1);
}

TEST_CASE("frames too old to match anything are dropped") {
  SyncAlone sync;
  sync.push(0, 0, 0);
  sync.push_set(1, {1, 2, 3});
  sync.harness.run();
  sync.push_set(1, {0});
  const auto set = sync.next();
  REQUIRE(set);
  CHECK(set->sequence() == 1);
  CHECK(set->timestamp_ns(0) == kPeriod);
  CHECK(sync.dropped(0, "too_old") == 1);
  CHECK(sync.dropped_sets() == 1);  // set 0 was seen, and never came to be
}

TEST_CASE("two pairs of cameras half a period apart do not starve each other") {
  SyncAlone sync;
  uint64_t sets = 0;
  for (uint64_t n = 0; n < 12; ++n) {
    sync.push_set(n, {0, 1});
    for (int camera : {2, 3}) sync.push(camera, n, static_cast<int64_t>(n) * kPeriod + kPeriod / 2 + 8 * kMs);
    sets += sync.sets();
  }
  sync.end();
  sets += sync.sets();
  CHECK(sets == 12);
}

TEST_CASE("two cameras whose time stamps are off together make no second set of the same moment") {
  SyncAlone sync;
  uint64_t n = 0;
  for (; n < 10; ++n) {
    const bool off = n >= 3 && n < 6;
    sync.push_set(n, {0, 1});
    for (int camera : {2, 3}) sync.push(camera, n, static_cast<int64_t>(n) * kPeriod + (off ? 22 * kMs : 0));
    sync.harness.run();
  }
  sync.end();
  uint64_t expected = 0;
  while (const auto set = sync.next()) CHECK(set->sequence() == expected++);
  CHECK(expected == n);
  CHECK(sync.dropped_sets() == 0);
}

TEST_CASE("a queue that runs full while a camera is missing does not block the others") {
  SyncAlone sync("repeat", 2);
  for (uint64_t n = 0; n < 8; ++n) {
    for (int camera : {0, 1, 2}) sync.push(camera, n, static_cast<int64_t>(n));  // time hardly moves
    sync.harness.run();
  }
  CHECK(sync.sets() >= 7);
}

TEST_CASE("sets that were dropped before the sync are not counted twice") {
  SyncAlone sync;
  sync.push_set(0);
  sync.push_set(5);
  CHECK(sync.sets() == 2);
  CHECK(sync.dropped_sets() == 0);
}

TEST_CASE("what waits at the end is sent, complete sets first and then the rest by the policy") {
  SyncAlone sync;
  sync.push_set(0);
  sync.push_set(1, {0, 1});
  sync.harness.run();
  CHECK(sync.sets() == 1);
  sync.end();
  const auto set = sync.next();
  REQUIRE(set);
  CHECK(set->sequence() == 1);
  CHECK(set->timestamp_ns(2) == 0);
  CHECK(sync.harness.pop_end("frames"));
}

TEST_CASE("every set is accounted for whatever the cameras lose") {
  const std::string missing = GENERATE("repeat", "skip");
  SyncAlone sync(missing);
  uint64_t seen = 0, sets = 0;
  uint32_t state = 1;
  for (uint64_t n = 0; n < 200; ++n) {
    bool any = false;
    for (int camera = 0; camera < 4; ++camera) {
      state = state * 1664525 + 1013904223;
      if (state >> 29 == 0) continue;  // one frame in eight is lost
      const int64_t jitter = (state >> 16) % 5 * kMs;
      sync.push(camera, n, static_cast<int64_t>(n) * kPeriod + jitter);
      any = true;
    }
    seen += any ? 1 : 0;
    sets += sync.sets();
  }
  sync.end();
  sets += sync.sets();
  CHECK(sets + sync.dropped_sets() == seen);
  CHECK(sets > (missing == "repeat" ? 150u : 60u));
}

TEST_CASE("a sync holds no frames once it has stopped") {
  SyncAlone sync;
  sync.push_set(0);
  sync.push_set(1, {0, 1});
  sync.harness.run();
  sync.harness.stop();
  CHECK_NOTHROW([&] {
    for (uint64_t n = 0; n < 60; ++n) sync.push_set(n + 2, {0});
  }());
}

TEST_CASE("the ledger counts sets that were seen and never made") {
  SetLedger ledger(8);
  for (uint64_t n : {3, 4, 4, 6, 9}) ledger.seen(n);
  CHECK(ledger.settle(6) == 2);
  ledger.seen(5);  // too late: accounted for already
  CHECK(ledger.next() == 7);
  CHECK(ledger.settle_all() == 1);
  CHECK(ledger.settle_all() == 0);
}
