#include "tests/integration/faulty_links.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "framework/link/call.h"

namespace svchain::testing {

namespace {

LinkDescription pass_through(const std::string& type, std::vector<ParameterDescription> parameters) {
  LinkDescription d;
  d.type = type;
  d.inputs = {{.name = "in", .types = {"bgr8"}, .count = 1}};
  d.outputs = {{.name = "out", .types = {"bgr8"}, .count = 1, .forwards = {"in"}}};
  d.parameters = std::move(parameters);
  return d;
}

class CameraFault final : public Link {
 public:
  LinkDescription describe() const override {
    auto d = pass_through("camera_fault",
                          {integer("lose_from", -1, {-1, 1e9}, "", "first frame that is lost"),
                           integer("lose_to", -1, {-1, 1e9}, "", "last frame that is lost"),
                           integer("twice_every", 0, {0, 1e9}, "", "every so many frames one comes twice"),
                           number("jitter_ms", 0, {0, 1e4}, "ms", "by turns early and late")});
    d.trigger = Trigger::kAny;  // a camera that gives nothing leaves no word of it either
    return d;
  }
  void configure(Configuration& c) override {
    c.output(0, c.input(0));
    lose_from_ = c.parameters().integer("lose_from");
    lose_to_ = c.parameters().integer("lose_to");
    twice_every_ = c.parameters().integer("twice_every");
    jitter_ns_ = static_cast<int64_t>(c.parameters().number("jitter_ms") * 1e6);
  }
  void process(Call& call) override {
    Frame frame = call.take(0);
    const auto n = static_cast<long long>(frame.sequence());
    if (n >= lose_from_ && n <= lose_to_ && lose_from_ >= 0) return;
    frame.set_timestamp_ns(0, frame.timestamp_ns() + (n % 2 ? jitter_ns_ : -jitter_ns_));
    if (twice_every_ > 0 && n % twice_every_ == 0 && call.room(0) > 1) call.send(0, frame.share());
    call.send(0, std::move(frame));
  }

 private:
  long long lose_from_ = -1, lose_to_ = -1, twice_every_ = 0;
  int64_t jitter_ns_ = 0;
};

class Thrower final : public Link {
 public:
  LinkDescription describe() const override {
    return pass_through("thrower", {integer("at", 0, {0, 1e9}, "", "frame at which it throws")});
  }
  void configure(Configuration& c) override {
    c.output(0, c.input(0));
    at_ = static_cast<uint64_t>(c.parameters().integer("at"));
  }
  void process(Call& call) override {
    if (call.input(0).sequence() == at_) throw std::runtime_error("the hood is open");
    call.send(0, call.take(0));
  }

 private:
  uint64_t at_ = 0;
};

class Slow final : public Link {
 public:
  LinkDescription describe() const override {
    return pass_through("slow", {integer("takes_ms", 100, {0, 10000}, "ms", "for every frame")});
  }
  void configure(Configuration& c) override {
    c.output(0, c.input(0));
    takes_ = std::chrono::milliseconds(c.parameters().integer("takes_ms"));
  }
  void process(Call& call) override {
    std::this_thread::sleep_for(takes_);
    call.send(0, call.take(0));
  }

 private:
  std::chrono::milliseconds takes_{0};
};

}  // namespace

void add_faulty_links(Catalogue& catalogue) {
  catalogue.add([] { return std::make_unique<CameraFault>(); });
  catalogue.add([] { return std::make_unique<Thrower>(); });
  catalogue.add([] { return std::make_unique<Slow>(); });
}

}  // namespace svchain::testing
