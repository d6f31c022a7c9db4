#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "ipc/message.h"
#include "usecases/svchain_bench/other_hops.h"
#include "usecases/svchain_bench/pinned.h"

namespace svchain::bench {

namespace {

class Queue {
 public:
  void push(const ipc::Message& message) {
    {
      std::unique_lock lock(mutex_);
      room_.wait(lock, [&] { return pushed_ - popped_ < slots_.size(); });
      slots_[pushed_++ % slots_.size()] = message;
    }
    filled_.notify_one();
  }
  ipc::Message pop() {
    ipc::Message message;
    {
      std::unique_lock lock(mutex_);
      filled_.wait(lock, [&] { return pushed_ > popped_; });
      message = slots_[popped_++ % slots_.size()];
    }
    room_.notify_one();
    return message;
  }

 private:
  std::mutex mutex_;
  std::condition_variable filled_, room_;
  std::array<ipc::Message, 64> slots_;
  size_t pushed_ = 0, popped_ = 0;
};

}  // namespace

RoundTrips condition_variable_round_trips(int trips) {
  const Pinned pinned(0);
  Queue there, back;
  std::thread other([&] {
    pin(1);
    for (int i = 0; i < trips; ++i) back.push(there.pop());
  });
  RoundTrips measured(trips);
  ipc::Message message;
  for (int i = 0; i < trips; ++i) {
    measured.depart();
    there.push(message);
    message = back.pop();
  }
  other.join();
  return measured;
}

double condition_variable_stream_ns(int messages) {
  const Pinned pinned(0);
  Queue queue;
  std::thread other([&] {
    pin(1);
    for (int i = 0; i < messages; ++i) queue.pop();
  });
  const int64_t start_ns = now_ns();
  const ipc::Message message;
  for (int i = 0; i < messages; ++i) queue.push(message);
  other.join();
  return static_cast<double>(now_ns() - start_ns) / messages;
}

}  // namespace svchain::bench
