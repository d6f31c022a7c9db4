#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <stdexcept>
#include <thread>

#include "ipc/message.h"
#include "usecases/svchain_bench/other_hops.h"
#include "usecases/svchain_bench/pinned.h"

namespace svchain::bench {

namespace {

/// An event loop and the thread that runs it, until the object goes.
class Loop {
 public:
  ~Loop() {
    work_.reset();
    thread_.join();
  }
  boost::asio::io_context& context() { return context_; }

 private:
  boost::asio::io_context context_{1};  // one thread runs it
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_ =
      boost::asio::make_work_guard(context_);
  std::thread thread_{[this] {
    pin(1);
    context_.run();
  }};
};

/// A message that goes to and fro. Lives on until both loops are gone.
struct PingPong {
  boost::asio::io_context &here, &there;
  RoundTrips& measured;
  int left;

  void depart(const ipc::Message& message) {
    if (left-- == 0) return;
    measured.depart();
    boost::asio::post(there,
                      [this, message] { boost::asio::post(here, [this, message] { depart(message); }); });
  }
};

}  // namespace

RoundTrips asio_round_trips(int trips) {
  const Pinned pinned(0);
  RoundTrips measured(trips);
  boost::asio::io_context here{1};
  {
    Loop there;
    PingPong ping_pong{here, there.context(), measured, trips};
    const auto work = boost::asio::make_work_guard(here);
    boost::asio::post(here, [&] { ping_pong.depart({}); });
    while (ping_pong.left >= 0) here.run_one();
  }
  return measured;
}

double asio_stream_ns(int messages) {
  const Pinned pinned(0);
  const int64_t start_ns = now_ns();
  uint64_t sum = 0;
  {
    Loop loop;
    ipc::Message message;
    for (int i = 0; i < messages; ++i) {
      message.sequence = static_cast<uint64_t>(i);
      boost::asio::post(loop.context(), [&sum, message] { sum += message.sequence; });
    }
  }
  if (sum != static_cast<uint64_t>(messages) * static_cast<uint64_t>(messages - 1) / 2)
    throw std::logic_error("asio lost a message");
  return static_cast<double>(now_ns() - start_ns) / messages;
}

}  // namespace svchain::bench
