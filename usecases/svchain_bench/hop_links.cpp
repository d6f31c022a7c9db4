#include "usecases/svchain_bench/hop_links.h"

#include "framework/link/call.h"
#include "ipc/message.h"
#include "usecases/svchain_bench/pinned.h"

namespace svchain::bench {

namespace {

/// Of frames of any number of buffers.
PortDescription port(std::string name, std::vector<std::string> forwards = {}) {
  return {.name = std::move(name), .types = {"tick"}, .forwards = std::move(forwards)};
}

LinkDescription description(std::string type, std::vector<PortDescription> inputs,
                            std::vector<PortDescription> outputs) {
  LinkDescription d;
  d.type = std::move(type);
  d.inputs = std::move(inputs);
  d.outputs = std::move(outputs);
  d.parameters = {integer("end", 0, {0, 1}, "", "end of the hop, whose CPU the core's thread stays on")};
  return d;
}

/// What all of them have: the first to be started takes its core's thread to the CPU of its end.
class HopLink : public Link {
 public:
  void configure(Configuration& configuration) override {
    end_ = static_cast<int>(configuration.parameters().integer("end"));
  }
  void start() override { pin(end_); }

 private:
  int end_ = 0;
};

PortFormat ticks(size_t buffers) {
  return PortFormat(buffers, Format::table("tick", 64));
}

class Ticker final : public HopLink {
 public:
  LinkDescription describe() const override {
    LinkDescription d = description("ticker", {}, {port("out")});
    d.parameters.push_back(
        integer("buffers", 1, {1, ipc::kMaxBuffers}, "", "of a frame, as cameras of a set"));
    return d;
  }
  void configure(Configuration& configuration) override {
    HopLink::configure(configuration);
    configuration.output(0, ticks(static_cast<size_t>(configuration.parameters().integer("buffers"))));
    count_ = configuration.pace().frames.value_or(1);
    next_ = 0;
  }
  void process(Call& call) override {
    Draft draft = call.create(0);
    draft.set_sequence(next_);
    call.captured();
    call.send(0, std::move(draft));
    if (++next_ == count_) call.end();
  }

 private:
  uint64_t count_ = 1, next_ = 0;
};

class Pass final : public HopLink {
 public:
  LinkDescription describe() const override {
    return description("pass", {port("in")}, {port("out", {"in"})});
  }
  void configure(Configuration& configuration) override {
    HopLink::configure(configuration);
    configuration.output(0, configuration.input(0));
  }
  void process(Call& call) override { call.send(0, call.take(0)); }
};

class Sink final : public HopLink {
 public:
  explicit Sink(Stretch& stretch) : stretch_(stretch) {}
  LinkDescription describe() const override { return description("sink", {port("in")}, {}); }
  void process(Call& call) override {
    const uint64_t sequence = call.input(0).sequence();
    if (sequence == stretch_.warm_up) stretch_.from_ns = now_ns();
    if (sequence == stretch_.last) stretch_.to_ns = now_ns();
  }

 private:
  Stretch& stretch_;
};

/// Sends a tick when the one before has come back, which then is done.
class Ping final : public HopLink {
 public:
  explicit Ping(RoundTrips& round_trips) : round_trips_(round_trips) {}
  LinkDescription describe() const override {
    return description("ping", {port("tick"), port("back")}, {port("out", {"tick"}), port("done", {"back"})});
  }
  void configure(Configuration& configuration) override {
    HopLink::configure(configuration);
    configuration.output(0, ticks(1));
    configuration.output(1, ticks(1));
  }
  void process(Call& call) override {
    round_trips_.depart();
    call.send(0, call.take(0));
    if (call.input(1)) call.send(1, call.take(1));
  }

 private:
  RoundTrips& round_trips_;
};

}  // namespace

void add_hop_links(Catalogue& catalogue, Stretch& stretch, RoundTrips& round_trips) {
  catalogue.add([] { return std::make_unique<Ticker>(); });
  catalogue.add([] { return std::make_unique<Pass>(); });
  catalogue.add([&stretch] { return std::make_unique<Sink>(stretch); });
  catalogue.add([&round_trips] { return std::make_unique<Ping>(round_trips); });
}

}  // namespace svchain::bench
