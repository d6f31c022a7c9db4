#include "framework/testing/harness.h"

#include <stdexcept>

#include "framework/chain/link_configuration.h"
#include "framework/chain/runner.h"

namespace svchain::testing {

namespace {

constexpr size_t kBuffers = 64;
constexpr int kDepth = 64;

size_t index_of(const std::vector<PortDescription>& ports, const std::string& name) {
  for (size_t i = 0; i < ports.size(); ++i) {
    if (ports[i].name == name) return i;
  }
  throw std::invalid_argument("no port \"" + name + "\"");
}

}  // namespace

struct LinkHarness::State {
  explicit State(std::unique_ptr<Link> tested)
      : link(std::move(tested)),
        description(link->describe()),
        returns(0),
        holder(0, pools, returns),
        link_holder(1, pools, returns),
        input_formats(description.inputs.size()),
        input_depths(description.inputs.size(), kDepth),
        input_pools(description.inputs.size()),
        input_edges(description.inputs.size()),
        output_edges(description.outputs.size()),
        output_depths(description.outputs.size(), kDepth),
        output_connected(description.outputs.size(), true) {
    entry.name = entry.type = description.type;
    entry.core = "core";
    entry.parameters = Parameters(description.parameters);
  }

  Pool* add_pool(const std::string& name, const Format& format, size_t buffers) {
    pools.push_back(std::make_unique<Pool>(static_cast<uint16_t>(pools.size()), name, format, buffers, 2,
                                           PoolOwner{0, &attention, 0}));
    return pools.back().get();
  }

  bool lacks_an_input() const {
    for (size_t i = 0; i < input_formats.size(); ++i) {
      if (input_formats[i].empty() && !description.inputs[i].optional) return true;
    }
    return false;
  }

  std::unique_ptr<Link> link;
  LinkDescription description;
  LinkEntry entry;
  std::map<std::string, Parameters> settings;
  VirtualClock clock;
  Attention attention{2};
  PoolTable pools;
  ReturnPath returns;
  Holder holder, link_holder;
  std::vector<PortFormat> input_formats;
  std::vector<int> input_depths;
  std::vector<std::vector<Pool*>> input_pools;
  std::vector<std::unique_ptr<Edge>> input_edges, output_edges;
  std::vector<int> output_depths;
  std::vector<bool> output_connected;
  std::vector<PortFormat> output_formats;
  std::vector<Pool*> own_pools;
  std::unique_ptr<Runner> runner;
  std::string failure;
};

LinkHarness::LinkHarness(std::unique_ptr<Link> link) : state_(std::make_unique<State>(std::move(link))) {}

LinkHarness::~LinkHarness() {
  stop();
}

Link& LinkHarness::link() {
  return *state_->link;
}

void LinkHarness::parameter(const std::string& name, nlohmann::json value) {
  state_->entry.parameters.put(name, std::move(value));
}

void LinkHarness::setting(const std::string& group, const std::string& key, nlohmann::json value) {
  state_->settings[group].put(key, std::move(value));
}

void LinkHarness::input(const std::string& port, PortFormat format, int depth) {
  const size_t i = index_of(state_->description.inputs, port);
  state_->input_formats[i] = std::move(format);
  state_->input_depths[i] = depth;
}

void LinkHarness::disconnect(const std::string& port) {
  state_->output_connected[index_of(state_->description.outputs, port)] = false;
}

void LinkHarness::output_depth(const std::string& port, int depth) {
  state_->output_depths[index_of(state_->description.outputs, port)] = depth;
}

Faults LinkHarness::configure() {
  State& s = *state_;
  std::vector<std::string> far_ends;
  for (const auto& port : s.description.inputs) far_ends.push_back("harness." + port.name);
  LinkConfiguration configuration(s.entry, s.description, s.settings, pace, s.input_formats, far_ends,
                                  s.output_connected);
  if (s.lacks_an_input()) {
    s.link->check(configuration);
    return configuration.found();
  }
  s.link->configure(configuration);
  if (!configuration.found().empty()) return configuration.found();
  s.output_formats = configuration.outputs();

  s.runner =
      std::make_unique<Runner>(s.entry.name, "core", s.link, s.description, OnError::kStop, s.link_holder,
                               s.clock, Runner::Hooks{[&s](Failure f) { s.failure = f.what; }, [] {}});
  s.runner->set_calls_without_room(configuration.wants_calls_without_room());
  const Edge::End harness{0, 0, &s.attention, nullptr, &s.holder};
  const Edge::End tested{0, 1, &s.attention, nullptr, &s.link_holder};
  for (size_t i = 0; i < s.input_formats.size(); ++i) {
    if (s.input_formats[i].empty()) continue;
    const std::string& name = s.description.inputs[i].name;
    for (const Format& f : s.input_formats[i]) s.input_pools[i].push_back(s.add_pool(name, f, kBuffers));
    s.input_edges[i] =
        std::make_unique<Edge>(name, s.input_depths[i], Policy::kBlock, harness, tested, s.clock);
    s.runner->connect_input(static_cast<int>(i), *s.input_edges[i], false, true);
  }
  for (size_t i = 0; i < s.description.outputs.size(); ++i) {
    const PortDescription& port = s.description.outputs[i];
    if (s.output_connected[i]) {
      s.output_edges[i] =
          std::make_unique<Edge>(port.name, s.output_depths[i], Policy::kBlock, tested, harness, s.clock);
    }
    const auto preloaded = static_cast<size_t>(configuration.preloaded_buffers()[i]);
    std::vector<Pool*> pools;
    if (port.forwards.empty()) {
      for (const Format& f : s.output_formats[i])
        pools.push_back(s.add_pool(port.name, f, preloaded ? preloaded : kBuffers));
    }
    s.own_pools.insert(s.own_pools.end(), pools.begin(), pools.end());
    s.runner->connect_output(static_cast<int>(i), s.output_edges[i].get(), pools, preloaded > 0);
  }
  s.link->start();
  s.runner->enable();
  return {};
}

const PortFormat& LinkHarness::output_format(const std::string& port) const {
  return state_->output_formats[index_of(state_->description.outputs, port)];
}

void LinkHarness::push(const std::string& port, const Push& push) {
  State& s = *state_;
  const size_t i = index_of(s.description.inputs, port);
  ipc::Message message;
  message.sequence = push.sequence;
  message.captured_ns = push.captured_ns;
  if (push.absent) {
    message.kind = ipc::MessageKind::kAbsence;
    return s.input_edges[i]->send(message);
  }
  for (Pool* pool : s.input_pools[i]) {
    const auto index = pool->take();
    if (!index) throw std::runtime_error("the link keeps all buffers of \"" + port + "\"");
    if (push.write) push.write(message.count, pool->bytes(*index));
    message.buffers[message.count] = {pool->id(), *index};
    message.timestamp_ns[message.count] = push.timestamp_ns;
    ++message.count;
  }
  s.input_edges[i]->send(message);
}

void LinkHarness::push_end(const std::string& port) {
  state_->input_edges[index_of(state_->description.inputs, port)]->send_end();
}

int LinkHarness::run(int calls) {
  int called = 0;
  while (called < calls && state_->runner->waiting(state_->clock.now_ns()).ready()) {
    state_->runner->run(state_->clock.now_ns());
    ++called;
  }
  return called;
}

namespace {

std::optional<ipc::Message> take_if(Edge* edge, ipc::MessageKind kind) {
  const ipc::Message* front = edge ? edge->front() : nullptr;
  if (!front || front->kind != kind) return std::nullopt;
  const ipc::Message message = *front;
  edge->pop(0);
  return message;
}

}  // namespace

std::optional<Frame> LinkHarness::pop(const std::string& port) {
  const size_t i = index_of(state_->description.outputs, port);
  const auto message = take_if(state_->output_edges[i].get(), ipc::MessageKind::kFrame);
  if (!message) return std::nullopt;
  return Frame(*message, state_->holder);
}

bool LinkHarness::pop_absence(const std::string& port) {
  const size_t i = index_of(state_->description.outputs, port);
  return take_if(state_->output_edges[i].get(), ipc::MessageKind::kAbsence).has_value();
}

bool LinkHarness::pop_end(const std::string& port) {
  const size_t i = index_of(state_->description.outputs, port);
  return take_if(state_->output_edges[i].get(), ipc::MessageKind::kEnd).has_value();
}

void LinkHarness::stop() {
  if (!state_ || !state_->runner) return;
  state_->link->stop();
  state_->runner->release_frames();
}

VirtualClock& LinkHarness::clock() {
  return state_->clock;
}
int64_t LinkHarness::wake_time_ns() const {
  return state_->runner->wake_time_ns();
}
uint64_t LinkHarness::processed() const {
  return state_->runner->counters().processed.value();
}
uint64_t LinkHarness::captured() const {
  return state_->runner->counters().captured.value();
}
std::map<std::string, uint64_t> LinkHarness::dropped() const {
  return state_->runner->counters().dropped.by_reason();
}
std::string LinkHarness::failure() const {
  return state_->failure;
}

size_t LinkHarness::buffers_in_use() const {
  size_t count = 0;
  for (const Pool* pool : state_->own_pools) count += pool->buffers() - pool->free();
  return count;
}

nlohmann::json LinkHarness::report() const {
  nlohmann::json report = nlohmann::json::object();
  state_->link->report(report);
  return report;
}

}  // namespace svchain::testing
