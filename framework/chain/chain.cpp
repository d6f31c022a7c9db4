#include "framework/chain/chain.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "framework/chain/runtime.h"

namespace svchain {

namespace {

void hire_workers(const Plan& plan, Chain::Runtime& r) {
  for (size_t c = 0; c < plan.cores.size(); ++c) {
    if (plan.cores[c].cpus == 1) continue;
    r.workers.push_back(std::make_unique<Workers>(plan.cores[c].cpus - 1));
    for (size_t l = 0; l < plan.links.size(); ++l)
      if (plan.links[l].core == static_cast<int>(c)) r.runners[l]->set_workers(r.workers.back().get());
  }
}

}  // namespace

Chain::Chain(Plan plan, ChainOptions options) : plan_(std::move(plan)), options_(std::move(options)) {}

Chain::~Chain() {
  stop();
  for (PlannedLink& planned : plan_.links) planned.link.reset();  // whatever they keep needs the pools
}

ChainState Chain::state() const {
  return state_.load();
}

const Plan& Chain::plan() const {
  return plan_;
}

void Chain::act(ChainAction action) {
  const auto next = next_state(state(), action);
  if (!next) {
    throw std::logic_error("chain \"" + plan_.use_case.name + "\" is " + name_of(state()) + ": it cannot " +
                           name_of(action) + " now");
  }
  state_ = *next;
}

Result<void> Chain::configure() {
  const ChainState before = state();
  act(ChainAction::kConfigure);
  for (const auto& held : outstanding()) {
    state_ = before;
    return svchain::fail(plan_.use_case.file, "link \"" + held.holder + "\" still keeps buffers of \"" +
                                                  held.pool + "\" from the last run");
  }
  auto setups = configure_links(plan_, options_.pace);
  if (Faults faults = options_.costs ? what_cannot_be_modelled(plan_) : Faults{}; !faults.empty()) {
    if (!setups) faults.insert(faults.end(), setups.error().begin(), setups.error().end());
    setups = tl::unexpected(std::move(faults));
  }
  if (!setups) {
    state_ = before;
    return tl::unexpected(std::move(setups.error()));
  }
  Runner::Hooks hooks;
  hooks.failed = [this](Failure failure) { fail(std::move(failure)); };
  hooks.ended = [this] {
    Runtime& r = *runtime_;
    if (r.ended.fetch_add(1) + 1 < r.runners.size()) return;
    r.finished_ns = r.clock->now_ns();
    const std::lock_guard lock(r.finished_mutex);
    r.finished.notify_all();
    if (options_.on_finished) options_.on_finished();
  };
  try {
    runtime_ = build_runtime(plan_, *setups, options_, hooks);
  } catch (const std::system_error& error) {
    state_ = before;
    return svchain::fail(plan_.use_case.file, error.what());
  }
  {
    const std::lock_guard lock(failure_mutex_);
    failure_.reset();
  }
  return {};
}

void Chain::on_core(int core, const std::function<void()>& work) {
  Runtime& r = *runtime_;
  Core& c = *r.cores[static_cast<size_t>(core)];
  if (r.threads.empty()) {
    work();
    c.wake();
    return;
  }
  std::promise<void> done;
  c.post([&] {
    try {
      work();
      done.set_value();
    } catch (...) {
      done.set_exception(std::current_exception());
    }
  });
  done.get_future().get();
}

void Chain::start() {
  act(ChainAction::kStart);
  Runtime& r = *runtime_;
  r.started_ns = r.clock->now_ns();
  if (r.faults) r.faults->start(r.started_ns);
  if (options_.execution == Execution::kThreads) {
    hire_workers(plan_, r);
    for (size_t c = 0; c < r.cores.size(); ++c) {
      r.threads.emplace_back(
          [&core = *r.cores[c], &soc = plan_.cores[c]] { core.loop(soc.spins, soc.parks); });
    }
  }
  r.links_started = true;
  for (auto it = plan_.source_to_sink.rbegin(); it != plan_.source_to_sink.rend(); ++it) {
    const auto l = static_cast<size_t>(*it);
    Runner& runner = *r.runners[l];
    try {
      on_core(plan_.links[l].core, [&runner] {
        runner.link().start();
        runner.enable();
      });
    } catch (const std::exception& error) {
      const auto& core = r.cores[static_cast<size_t>(plan_.links[l].core)];
      fail({core->name(), plan_.links[l].entry.name, 0, std::string("start: ") + error.what()});
      return stop();
    }
  }
  r.all_started = true;
  for (auto& core : r.cores) core->wake();
}

void Chain::request_end() {
  const auto next = next_state(state(), ChainAction::kDrain);
  if (!next) return;  // it is not running: there is nothing to end
  state_ = *next;
  for (auto& runner : runtime_->runners) {
    if (runner->is_source()) runner->request_end();
  }
  for (auto& core : runtime_->cores) core->wake();
}

bool Chain::finished() const {
  return runtime_ && runtime_->ended.load() == runtime_->runners.size();
}

void Chain::stop() {
  const ChainState before = state();
  if ((before == ChainState::kRunning || before == ChainState::kDraining) && !failure()) request_end();
  act(ChainAction::kStop);
  if (!runtime_ || !runtime_->links_started) return;
  Runtime& r = *runtime_;
  if (r.threads.empty()) {
    while (step() || advance_clock() || excuse_lost_feedback()) {
    }
  } else if (r.all_started) {
    std::unique_lock lock(r.finished_mutex);
    r.finished.wait_for(lock, options_.drain_deadline, [this] { return finished(); });
  }
  if (r.finished_ns == 0) r.finished_ns = r.clock->now_ns();
  for (const int link : plan_.source_to_sink) {
    const auto l = static_cast<size_t>(link);
    on_core(plan_.links[l].core, [&runner = *r.runners[l]] {
      runner.link().stop();
      runner.release_frames();
    });
  }
  for (auto& core : r.cores) core->quit();
  for (auto& thread : r.threads) thread.join();
  r.threads.clear();
  for (auto& runner : r.runners) runner->set_workers(nullptr);
  r.workers.clear();
  r.links_started = false;
  settle();
}

/// Everything stands still: what is left on the edges and in the rings of returns goes home.
void Chain::settle() {
  Runtime& r = *runtime_;
  for (auto& edge : r.edges) {
    edge->drop_late();
    while (const ipc::Message* message = edge->front()) {
      Frame(*message, *edge->consumer().holder).release();
      edge->pop(r.clock->now_ns());
    }
  }
  for (auto& path : r.return_paths) path->collect(r.pools);
}

std::optional<Failure> Chain::failure() const {
  const std::lock_guard lock(failure_mutex_);
  return failure_;
}

void Chain::fail(Failure failure) {
  {
    const std::lock_guard lock(failure_mutex_);
    if (!failure_) failure_ = std::move(failure);
  }
  request_end();
}

std::future<nlohmann::json> Chain::control(const std::string& link, const std::string& command,
                                           nlohmann::json arguments) {
  auto answer = std::make_shared<std::promise<nlohmann::json>>();
  std::vector<std::string> names;
  for (size_t l = 0; l < plan_.links.size(); ++l) {
    names.push_back(plan_.links[l].entry.name);
    if (names.back() != link || !runtime_) continue;
    Runner& runner = *runtime_->runners[l];
    runtime_->cores[static_cast<size_t>(plan_.links[l].core)]->post(
        [answer, &runner, command, arguments = std::move(arguments)] {
          try {
            answer->set_value(runner.link().control(command, arguments));
          } catch (...) {
            answer->set_exception(std::current_exception());
          }
        });
    return answer->get_future();
  }
  answer->set_exception(
      std::make_exception_ptr(std::invalid_argument("no link \"" + link + "\"" + did_you_mean(link, names))));
  return answer->get_future();
}

bool Chain::step(const Core::Choice& choice) {
  Runtime& r = *runtime_;
  if (r.modelled) return r.modelled->step(choice);
  const size_t count = r.cores.size();
  const size_t first = choice ? choice(count) : r.next_core;
  for (size_t i = 0; i < count; ++i) {
    const size_t c = (first + i) % count;
    if (!r.cores[c]->step(choice)) continue;
    r.next_core = (c + 1) % count;
    return true;
  }
  return false;
}

bool Chain::advance_clock() {
  Runtime& r = *runtime_;
  if (r.modelled) return r.modelled->advance();
  std::optional<int64_t> earliest;
  for (auto& core : r.cores) {
    const auto wake = core->next_wake_ns();
    if (wake && (!earliest || *wake < *earliest)) earliest = wake;
  }
  if (!earliest || !r.virtual_clock) return false;
  r.virtual_clock->advance_to(*earliest);
  return true;
}

uint64_t Chain::calls() const {
  uint64_t sum = 0;
  for (const auto& core : runtime_->cores) sum += core->calls();
  return sum;
}

bool Chain::busy() const {
  return std::any_of(runtime_->cores.begin(), runtime_->cores.end(),
                     [](const auto& core) { return core->busy(); });
}

bool Chain::excuse_lost_feedback() {
  Runtime& r = *runtime_;
  bool any = false;
  for (size_t l = 0; l < r.runners.size(); ++l) {
    on_core(plan_.links[l].core, [&, &runner = *r.runners[l]] {
      if (runner.request_lost_state()) any = true;
      if (runner.waiting(r.clock->now_ns()).what != Runner::Wait::kFeedback) return;
      runner.excuse_feedback();
      any = true;
    });
  }
  return any;
}

std::vector<std::string> Chain::who_waits() {
  std::vector<std::string> lines;
  for (size_t l = 0; l < plan_.links.size(); ++l) {
    std::string line;
    on_core(plan_.links[l].core, [&] { line = waiting_line(l); });
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

std::string Chain::waiting_line(size_t link) {
  Runner& runner = *runtime_->runners[link];
  if (runner.ended()) return {};
  const PlannedLink& planned = plan_.links[link];
  const Runner::Waiting w = runner.waiting(runtime_->clock->now_ns());
  const auto port = static_cast<size_t>(std::max(0, w.port));
  std::string line = planned.entry.name + " (" + plan_.cores[static_cast<size_t>(planned.core)].name + ") ";
  switch (w.what) {
    case Runner::Wait::kNothing:
      return line + "is ready";
    case Runner::Wait::kTime:
      return line + "waits for its time";
    case Runner::Wait::kEnded:
      return line + "is not running";
    case Runner::Wait::kFrame:
    case Runner::Wait::kFeedback: {
      const PlannedEdge& edge = plan_.edges[static_cast<size_t>(std::max(0, planned.input_edges[port]))];
      return line + "waits for " + planned.description.inputs[port].name + " from " + edge.entry.from_link +
             "." + edge.entry.from_port;
    }
    case Runner::Wait::kRoom: {
      const PlannedEdge& edge = plan_.edges[static_cast<size_t>(planned.output_edges[port])];
      return line + "waits for room on " + edge.entry.name() + " (" + std::to_string(edge.entry.depth) +
             " of " + std::to_string(edge.entry.depth) + " waiting there)";
    }
    case Runner::Wait::kBuffer:
      return line + "waits for a free buffer for " + planned.description.outputs[port].name;
  }
  return line;
}

std::vector<OutstandingBuffers> Chain::outstanding() const {
  std::vector<OutstandingBuffers> list;
  if (!runtime_) return list;
  for (const auto& pool : runtime_->pools) {
    if (pool->free() == pool->buffers()) continue;
    for (size_t l = 0; l < plan_.links.size(); ++l) {
      if (const size_t held = pool->held_by(l))
        list.push_back({pool->name(), plan_.links[l].entry.name, held});
    }
  }
  return list;
}

}  // namespace svchain
