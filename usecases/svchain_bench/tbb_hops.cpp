#include "usecases/svchain_bench/tbb_hops.h"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <tbb/flow_graph.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/version.h>

#include "ipc/message.h"
#include "usecases/svchain_bench/round_trips.h"

namespace svchain::bench {

namespace {

namespace flow = tbb::flow;

/// The end of every graph: messages have to come one by one.
struct Arrivals {
  uint64_t next = 0;

  void note(const ipc::Message& message) {
    if (message.sequence != next++) throw std::runtime_error("TBB: a message is lost or out of order");
  }
  void require(int messages) const {
    if (next != static_cast<uint64_t>(messages)) throw std::runtime_error("TBB lost a message");
  }
};

}  // namespace

std::string tbb_version() {
  return std::to_string(TBB_VERSION_MAJOR) + "." + std::to_string(TBB_VERSION_MINOR);
}

/// The thread that puts messages in and another that takes them out.
double tbb_stream_ns(int messages) {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  tbb::task_arena arena(2, 1);
  double per_message_ns = 0;
  arena.execute([&] {
    flow::graph graph;
    Arrivals arrivals;
    flow::function_node<ipc::Message, flow::continue_msg> sink(graph, flow::serial,
                                                               [&](const ipc::Message& message) {
                                                                 arrivals.note(message);
                                                                 return flow::continue_msg();
                                                               });
    ipc::Message message;
    const int64_t start_ns = now_ns();
    for (int i = 0; i < messages; ++i) {
      message.sequence = static_cast<uint64_t>(i);
      sink.try_put(message);
    }
    graph.wait_for_all();
    per_message_ns = static_cast<double>(now_ns() - start_ns) / messages;
    arrivals.require(messages);
  });
  return per_message_ns;
}

/// Lightweight nodes are called by the one before at once, which is the fastest on one thread.
double tbb_line_ns(int nodes, int messages) {
  using Node = flow::function_node<ipc::Message, ipc::Message, flow::queueing_lightweight>;
  tbb::task_arena arena(1, 1);
  double per_message_ns = 0;
  arena.execute([&] {
    flow::graph graph;
    Arrivals arrivals;
    std::deque<Node> line;
    for (int i = 0; i < nodes; ++i) {
      line.emplace_back(graph, flow::serial, [](const ipc::Message& message) noexcept { return message; });
      if (i > 0) flow::make_edge(line[line.size() - 2], line.back());
    }
    flow::function_node<ipc::Message, flow::continue_msg, flow::queueing_lightweight> sink(
        graph, flow::serial, [&](const ipc::Message& message) noexcept {
          arrivals.next += message.sequence == arrivals.next;
          return flow::continue_msg();
        });
    if (!line.empty()) flow::make_edge(line.back(), sink);
    ipc::Message message;
    const int64_t start_ns = now_ns();
    for (int i = 0; i < messages; ++i) {
      message.sequence = static_cast<uint64_t>(i);
      line.front().try_put(message);
      graph.wait_for_all();
    }
    per_message_ns = static_cast<double>(now_ns() - start_ns) / messages;
    arrivals.require(messages);
  });
  return per_message_ns;
}

}  // namespace svchain::bench
