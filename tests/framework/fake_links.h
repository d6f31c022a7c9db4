#pragma once
// Small links that carry numbers, for tests of the framework: what went where can be read off the values.

#include <cstring>
#include <stdexcept>
#include <vector>

#include "framework/chain/chain.h"
#include "framework/chain/run.h"
#include "framework/link/call.h"
#include "framework/link/catalogue.h"
#include "framework/usecase/plan.h"

namespace svchain::testing {

inline Format number_format() {
  return Format::table("number", sizeof(int64_t));
}

inline int64_t value_of(const Frame& frame) {
  int64_t v;
  std::memcpy(&v, frame.bytes().data(), sizeof(v));
  return v;
}

inline void send_number(Call& call, int port, int64_t v) {
  Draft draft = call.create(port);
  std::memcpy(draft.bytes().data(), &v, sizeof(v));
  call.send(port, std::move(draft));
}

/// 0, 1, 2, ... count - 1.
class Numbers : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "numbers";
    d.outputs = {{.name = "out", .types = {"number"}, .count = 1}};
    d.parameters = {integer("count", 10, {0, 1e9}, "", "how many")};
    return d;
  }
  void configure(Configuration& c) override {
    c.output(0, {number_format()});
    count_ = static_cast<uint64_t>(c.parameters().integer("count"));
    if (c.pace().frames) count_ = *c.pace().frames;
    next_ = 0;
    timed_ = c.pace().virtual_clock;
  }
  void process(Call& call) override {
    if (next_ == count_) return call.end();
    Draft draft = call.create(0);
    const auto v = static_cast<int64_t>(next_);
    std::memcpy(draft.bytes().data(), &v, sizeof(v));
    draft.set_sequence(next_++);
    call.captured(1);
    if (timed_) call.wake_at(static_cast<int64_t>(next_) * 1'000'000);
    call.send(0, std::move(draft));
  }

 private:
  uint64_t count_ = 0, next_ = 0;
  bool timed_ = false;
};

/// out = in + plus; throws at one frame, or says nothing at one frame.
class Add : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "add";
    d.inputs = {{.name = "in", .types = {"number"}, .count = 1}};
    d.outputs = {{.name = "out", .types = {"number"}, .count = 1}};
    d.parameters = {integer("plus", 0, {-1000, 1000}, "", "added"),
                    integer("throw_at", -1, {-1, 1e9}, "", "frame at which it throws"),
                    integer("silent_at", -1, {-1, 1e9}, "", "frame at which it sends nothing"),
                    boolean("bad_format", false, "gives another format than it says")};
    return d;
  }
  void configure(Configuration& c) override {
    const auto format = c.parameters().flag("bad_format") ? Format::table("other", 8) : number_format();
    c.output(0, {format});
    plus_ = c.parameters().integer("plus");
    throw_at_ = c.parameters().integer("throw_at");
    silent_at_ = c.parameters().integer("silent_at");
  }
  void process(Call& call) override {
    const int64_t v = value_of(call.input(0));
    const auto sequence = static_cast<long long>(call.input(0).sequence());
    if (sequence == throw_at_) throw std::runtime_error("cannot add to " + std::to_string(v));
    if (sequence == silent_at_) return;
    send_number(call, 0, v + plus_);
  }
  nlohmann::json control(const std::string& command, const nlohmann::json& arguments) override {
    if (command != "plus") return Link::control(command, arguments);
    plus_ = arguments.get<int64_t>();
    return {{"plus", plus_}};
  }

 private:
  int64_t plus_ = 0;
  long long throw_at_ = -1, silent_at_ = -1;
};

/// The same frame twice.
class Fork : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "fork";
    d.inputs = {{.name = "in", .types = {"number"}, .count = 1}};
    d.outputs = {{.name = "a", .types = {"number"}, .count = 1, .forwards = {"in"}},
                 {.name = "b", .types = {"number"}, .count = 1, .forwards = {"in"}}};
    return d;
  }
  void configure(Configuration& c) override {
    c.output(0, c.input(0));
    c.output(1, c.input(0));
  }
  void process(Call& call) override {
    call.send(0, call.input(0).share());
    call.send(1, call.take(0));
  }
};

/// out = 1000 a + b, frame by frame.
class Join : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "join";
    d.inputs = {{.name = "a", .types = {"number"}, .count = 1},
                {.name = "b", .types = {"number"}, .count = 1}};
    d.outputs = {{.name = "out", .types = {"number"}, .count = 1}};
    return d;
  }
  void configure(Configuration& c) override { c.output(0, {number_format()}); }
  void process(Call& call) override {
    send_number(call, 0, 1000 * value_of(call.input(0)) + value_of(call.input(1)));
  }
};

/// A loop's head: out = 1000 in + the last feedback (-1 before the first); echo = in.
class Loop : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "loop";
    d.inputs = {{.name = "in", .types = {"number"}, .count = 1},
                {.name = "feedback", .types = {"number"}, .count = 1, .optional = true}};
    d.outputs = {{.name = "out", .types = {"number"}, .count = 1},
                 {.name = "echo", .types = {"number"}, .count = 1}};
    return d;
  }
  void configure(Configuration& c) override {
    c.output(0, {number_format()});
    c.output(1, {number_format()});
    last_ = -1;
  }
  void process(Call& call) override {
    if (const Frame& token = call.input(1)) last_ = value_of(token);
    const int64_t v = value_of(call.input(0));
    send_number(call, 0, 1000 * v + last_);
    send_number(call, 1, v);
  }

 private:
  int64_t last_ = -1;
};

/// Keeps what it sees in the vector it is given; delivers.
class Collect : public Link {
 public:
  explicit Collect(std::vector<int64_t>* seen, std::vector<const void*>* where)
      : seen_(seen), where_(where) {}
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "collect";
    d.inputs = {{.name = "in", .types = {"number"}, .count = 1}};
    d.parameters = {boolean("hoard", false, "never lets go of a frame")};
    d.delivers = true;
    return d;
  }
  void configure(Configuration& c) override {
    hoards_ = c.parameters().flag("hoard");
    hoard_.reserve(1000);
    if (hoards_) c.holds(0, 1000);
  }
  void process(Call& call) override {
    seen_->push_back(value_of(call.input(0)));
    where_->push_back(call.input(0).bytes().data());
    if (hoards_) hoard_.push_back(call.take(0));
  }

 private:
  std::vector<int64_t>* seen_;
  std::vector<const void*>* where_;
  bool hoards_ = false;
  std::vector<Frame> hoard_;
};

struct Fakes {
  std::vector<int64_t> seen;
  std::vector<const void*> where;
  Catalogue catalogue;
  Fakes() {
    catalogue.add([] { return std::make_unique<Numbers>(); });
    catalogue.add([] { return std::make_unique<Add>(); });
    catalogue.add([] { return std::make_unique<Fork>(); });
    catalogue.add([] { return std::make_unique<Join>(); });
    catalogue.add([] { return std::make_unique<Loop>(); });
    catalogue.add([this] { return std::make_unique<Collect>(&seen, &where); });
  }

  std::string soc = R"({"name":"duo","cores":{"A":{"kind":"M4"},"B":{"kind":"C66x"}},"roles":{"host":"A"}})";

  Plan plan(const std::string& use_case) const {
    auto read = parse_use_case(use_case, "test.json", catalogue);
    if (!read) throw std::runtime_error(read.error().front().text());
    auto cores = parse_soc(soc, "duo.json");
    if (!cores) throw std::runtime_error(cores.error().front().text());
    auto made = make_plan(std::move(*read), std::move(*cores), catalogue);
    if (!made) throw std::runtime_error(made.error().front().text());
    return std::move(*made);
  }
  std::unique_ptr<Chain> chain(const std::string& use_case, ChainOptions options) const {
    auto chain = std::make_unique<Chain>(plan(use_case), std::move(options));
    if (auto done = chain->configure(); !done) throw std::runtime_error(done.error().front().text());
    return chain;
  }
};

inline ChainOptions by_hand() {
  ChainOptions options;
  options.execution = Execution::kByHand;
  options.pace.virtual_clock = true;
  return options;
}

/// numbers (A) -> add (B) -> collect (A), with what is given spliced in.
inline std::string line(const std::string& add_params = "{}", const std::string& extra_of_add = "",
                        const std::string& first_edge = R"("numbers.out -> add.in")") {
  return R"({"name":"line","links":{"numbers":{"type":"numbers","core":"A"},"add":{"type":"add","core":"B","params":)" +
         add_params + extra_of_add + R"(},"collect":{"type":"collect","core":"A"}},"edges":[)" + first_edge +
         R"(,"add.out -> collect.in"]})";
}

/// A loop whose tail (add) is on the given core.
inline std::string loop(const std::string& tail_core, const std::string& add_params = R"({"plus":500})",
                        const std::string& extra_of_add = "") {
  return R"({"name":"loop","links":{"numbers":{"type":"numbers","core":"A"},"loop":{"type":"loop","core":"B"},
    "add":{"type":"add","core":")" +
         tail_core + R"(","params":)" + add_params + extra_of_add +
         R"(},"collect":{"type":"collect","core":"A"}},
    "edges":["numbers.out -> loop.in","loop.out -> collect.in","loop.echo -> add.in",
      {"from":"add.out","to":"loop.feedback","feedback":true}]})";
}

}  // namespace svchain::testing
