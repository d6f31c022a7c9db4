#include "framework/trace/recorder.h"

#include "tests/allocation_count.h"
#include "tests/catch.h"

using namespace svchain;
using Kind = TraceEvent::Kind;

TEST_CASE("a recorder keeps what happened in its order, and what leaves at the end gets the end's time") {
  Recorder recorder(100);
  recorder.taken(3, 1, true, 10);
  recorder.sent(4, 1, true, 2, Recorder::kAtEnd);
  recorder.sent(5, 7, false, 0, 15);
  recorder.link_dropped(1, "late", 3);
  recorder.called(Kind::kCall, 1, 42, 10, 20);
  recorder.end_run(20);
  recorder.edge_dropped(4, "queue_full");
  recorder.end_run(30);

  const auto events = recorder.events();
  REQUIRE(events.size() == 6);
  const Kind kinds[] = {Kind::kTaken,    Kind::kSent, Kind::kSent,
                        Kind::kLinkDrop, Kind::kCall, Kind::kEdgeDrop};
  const int64_t times_ns[] = {10, 20, 15, 20, 10, 30};
  for (size_t i = 0; i < events.size(); ++i) {
    CHECK(events[i].kind == kinds[i]);
    CHECK(events[i].time_ns == times_ns[i]);
  }
  CHECK(events[1].taken_back == 2);
  CHECK(events[2].is_frame == false);
  CHECK(events[3].reason == std::string("late"));
  CHECK(events[4].end_ns == 20);
  CHECK(events[4].number == 42);
  CHECK(recorder.lost() == 0);
}

TEST_CASE("a recorder that is full keeps what it has and counts the rest") {
  Recorder recorder(3);
  for (uint64_t i = 1; i <= 10; ++i) recorder.taken(0, i, true, static_cast<int64_t>(i));
  recorder.end_run(11);
  REQUIRE(recorder.events().size() == 3);
  CHECK(recorder.events().back().number == 3);
  CHECK(recorder.lost() == 7);
}

TEST_CASE("recording allocates nothing, full or not") {
  Recorder recorder(1000);
  const size_t before = testing::allocation_count();
  for (uint64_t i = 0; i < 1000; ++i) {
    recorder.sent(0, i, true, 0, Recorder::kAtEnd);
    recorder.called(Kind::kCall, 0, i, 0, 1);
    recorder.end_run(1);
  }
  CHECK(testing::allocation_count() == before);
  CHECK(recorder.lost() == 1000);
}
