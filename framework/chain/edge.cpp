#include "framework/chain/edge.h"

#include <algorithm>

namespace svchain {

Edge::Edge(std::string name, int depth, Policy policy, const End& producer, const End& consumer,
           const Clock& clock)
    : name_(std::move(name)),
      depth_(policy == Policy::kLatest ? 1 : depth),
      policy_(policy),
      producer_(producer),
      consumer_(consumer),
      clock_(clock),
      ipc_(producer.core != consumer.core),
      region_("svchain:" + name_, ipc::Ring<ipc::Message>::bytes(static_cast<size_t>(depth_) + 1)),
      ring_(ipc::Ring<ipc::Message>::create(region_.bytes().data(), static_cast<size_t>(depth_) + 1)) {}

int Edge::room() const {
  if (policy_ != Policy::kBlock) return depth_;
  return std::max(0, depth_ - static_cast<int>(ring_.size()));
}

void Edge::send(ipc::Message message) {
  if (ipc_) message.sent_ns = clock_.now_ns();
  if (policy_ == Policy::kDropNewest && ring_.size() >= static_cast<size_t>(depth_)) {
    return drop(message, "queue_full");
  }
  if (policy_ == Policy::kDropOldest) evict_to(static_cast<size_t>(depth_) - 1, "overwritten");
  if (policy_ == Policy::kLatest) evict_to(0, "overwritten");
  push(message);
}

void Edge::send_end() {
  ipc::Message end;
  end.kind = ipc::MessageKind::kEnd;
  push(end);
}

void Edge::push(const ipc::Message& message) {
  ring_.push(
      message);  // never full: depth is kept by room() and the policies, and the end has a slot of its own
  if (message.kind == ipc::MessageKind::kFrame) messages_.add();
  const auto was_empty = [this] { return ring_.size() <= 1; };
  if (!ipc_ || was_empty()) tell(consumer_);
}

void Edge::evict_to(size_t kept, const char* reason) {
  ipc::Message oldest;
  while (ring_.size() > kept && ring_.pop(oldest)) drop(oldest, reason);
}

void Edge::drop(const ipc::Message& message, const char* reason) {
  if (message.kind != ipc::MessageKind::kFrame) return;
  full_.add();
  dropped_.add(reason);
  Frame(message, *producer_.holder).release();
}

bool Edge::take(ipc::Message& message) {
  if (!ring_.pop(message)) return false;
  if (ipc_ && message.kind == ipc::MessageKind::kFrame) hop_.record(clock_.now_ns() - message.sent_ns);
  const auto was_full = [this] { return ring_.size() + 1 >= static_cast<size_t>(depth_); };
  if (!ipc_ || was_full()) tell(producer_);
  return true;
}

void Edge::tell(const End& end) {
  if (ipc_) {
    end.doorbell->ring();
  } else {
    end.attention->mark(end.runner);
  }
}

}  // namespace svchain
