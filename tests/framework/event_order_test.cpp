#include "framework/trace/event_order.h"

#include "tests/catch.h"

using namespace svchain;
using Kind = TraceEvent::Kind;

namespace {

/// Link 0 on core 0 sends three frames to link 1 on core 1, through a queue for one, all at one moment.
struct OneMoment {
  OneMoment() {
    for (uint64_t i = 1; i <= 3; ++i) {
      sender.sent(0, i, true, 0, Recorder::kAtEnd);
      sender.called(Kind::kCall, 0, i, 5, 5);
      sender.end_run(5);
      receiver.taken(0, i, true, 5);
      receiver.called(Kind::kCall, 1, i, 5, 5);
      receiver.end_run(5);
    }
    run.cores = {"A", "B"};
    run.links = {"from", "to"};
    run.edges = {{"from.out -> to.in", 1, 1, true}};
  }
  /// The kinds of the messages' events in their order, and how many wait after each.
  std::vector<std::pair<Kind, int>> messages() const {
    std::vector<std::pair<Kind, int>> list;
    for (const OrderedEvent& e : in_order(run)) {
      if (e.event.kind == Kind::kSent || e.event.kind == Kind::kTaken)
        list.emplace_back(e.event.kind, e.waiting);
    }
    return list;
  }

  Recorder sender{100}, receiver{100};
  TracedRun run;
};

using Messages = std::vector<std::pair<Kind, int>>;
const Messages kInTurn = {{Kind::kSent, 1},  {Kind::kTaken, 0}, {Kind::kSent, 1},
                          {Kind::kTaken, 0}, {Kind::kSent, 1},  {Kind::kTaken, 0}};

}  // namespace

TEST_CASE("at one moment no message is sent before there is room, and none taken before it was sent") {
  OneMoment moment;
  moment.run.recorders = {&moment.sender, &moment.receiver};
  CHECK(moment.messages() == kInTurn);
}

TEST_CASE("nor where the receiver's core comes first") {
  OneMoment moment;
  moment.run.recorders = {&moment.receiver, &moment.sender};
  CHECK(moment.messages() == kInTurn);
}

TEST_CASE("what was taken back makes room") {
  OneMoment moment;
  Recorder sender(100), receiver(100);
  sender.sent(0, 1, true, 0, 5);
  sender.sent(0, 2, true, 1, 5);
  receiver.taken(0, 2, true, 5);
  moment.run.recorders = {&sender, &receiver};
  CHECK(moment.messages() == Messages{{Kind::kSent, 1}, {Kind::kSent, 1}, {Kind::kTaken, 0}});
}

TEST_CASE("a message whose sending was lost leaves the queue within its bounds, and has no arrow") {
  OneMoment moment;
  const Recorder nothing(1);
  moment.run.recorders = {&nothing, &moment.receiver};
  for (const OrderedEvent& e : in_order(moment.run)) {
    CHECK(e.event.kind != Kind::kReceived);
    CHECK(e.waiting == 0);
  }
}
