#include "framework/chain/edge.h"

#include <algorithm>
#include <new>

#include "framework/buffer/frame.h"

namespace svchain {

namespace {

using Across = ipc::Ring<ipc::Message>;
using Evicting = ipc::EvictingRing<ipc::Message>;

bool evicts(Policy policy) {
  return policy == Policy::kDropOldest || policy == Policy::kLatest;
}

}  // namespace

Edge::Edge(std::string name, int depth, Policy policy, const End& producer, const End& consumer,
           const Clock& clock, std::optional<int64_t> modelled_latency_ns)
    : depth_(policy == Policy::kLatest ? 1 : depth),
      policy_(policy),
      way_(modelled_latency_ns              ? Way::kModelled
           : producer.core == consumer.core ? Way::kLocal
           : evicts(policy)                 ? Way::kEvicting
                                            : Way::kAcross),
      producer_(producer),
      consumer_(consumer),
      local_(way_ <= Way::kModelled ? static_cast<size_t>(depth_) + 1 : 0),
      clock_(clock),
      name_(std::move(name)),
      latency_ns_(modelled_latency_ns.value_or(0)) {
  if (way_ <= Way::kModelled) {
    own_waits_ = std::make_unique<Waits>();
    waits_ = own_waits_.get();
    return;
  }
  const size_t capacity = static_cast<size_t>(depth_) + 1;  // the end has a slot of its own
  const bool evicting = way_ == Way::kEvicting;
  region_ = ipc::SharedRegion(
      "svchain:" + name_, sizeof(Waits) + (evicting ? Evicting::bytes(capacity) : Across::bytes(capacity)));
  std::byte* memory = region_.bytes().data();
  waits_ = new (memory) Waits;
  if (evicting) {
    evicting_ = Evicting::create(memory + sizeof(Waits), capacity);
  } else {
    ring_ = Across::create(memory + sizeof(Waits), capacity);
  }
}

void Edge::set_recorders(int number, Recorder& producer, Recorder& consumer) {
  number_ = number;
  producer_recorder_ = &producer;
  consumer_recorder_ = &consumer;
}

/// What the producer knows to lie there, what it has not published yet among it.
size_t Edge::queued() {
  switch (way_) {
    case Way::kLocal:
      return local_.size() + late();
    case Way::kModelled:
      return local_.size() + held_back_.size() + late();
    case Way::kAcross:
      return ring_.filled() + late();
    case Way::kEvicting:
      return evicting_.size() + late();
  }
  return 0;
}

int Edge::room() {
  if (in_force(FaultKind::kFull)) return 0;
  if (policy_ != Policy::kBlock) return depth_;
  return std::max(0, depth_ - static_cast<int>(queued()));
}

bool Edge::has_room() {
  const auto depth = static_cast<size_t>(depth_);
  if (policy_ != Policy::kBlock) return true;
  if (trouble_) {
    if (in_force(FaultKind::kFull)) return false;  // the core looks again when that is over
    if (late() > 0 && queued() >= depth) {
      wants_room_ = true;
      return false;
    }
  }
  if (way_ == Way::kLocal) {
    wants_room_ = local_.size() >= depth;
    return !wants_room_;
  }
  if (way_ == Way::kModelled) return queued() < depth;
  if (ring_.filled_at_most() < depth || ring_.filled() < depth) return true;
  waits_->room.set();
  return ring_.filled() < depth;
}

void Edge::send(const ipc::Message& message) {
  if (way_ == Way::kModelled) return held_back_.push_back(message);
  leave(message);
}

void Edge::leave(const ipc::Message& message) {
  trouble_ ? leave_if_nothing_is_wrong(message) : apply_policy(message);
}

void Edge::apply_policy(const ipc::Message& message) {
  const bool full = policy_ != Policy::kBlock && in_force(FaultKind::kFull);
  if (full || (policy_ == Policy::kDropNewest && queued() >= static_cast<size_t>(depth_)))
    return drop(message, "queue_full");
  size_t taken_back = 0;
  if (policy_ == Policy::kDropOldest) taken_back = evict_to(static_cast<size_t>(depth_) - 1, "overwritten");
  if (policy_ == Policy::kLatest) taken_back = evict_to(0, "overwritten");
  const int64_t left_ns = push(message);
  if (!producer_recorder_) return;
  const bool is_frame = message.kind == ipc::MessageKind::kFrame;
  producer_recorder_->sent(number_, sent_, is_frame, taken_back, left_ns);
}

void Edge::send_end() {
  ipc::Message end;
  end.kind = ipc::MessageKind::kEnd;
  if (way_ == Way::kModelled) return held_back_.push_back(end);
  late() == 0 ? void(push(end)) : hold_up(end, 0);
}

/// Never full: depth is kept by has_room() and the policies, and the end has a slot of its own. Returns when
/// it leaves.
int64_t Edge::push(const ipc::Message& message) {
  if (message.kind == ipc::MessageKind::kFrame) messages_.add();
  ++sent_;
  if (way_ == Way::kLocal) {
    local_.push(message);
    consumer_.attention->mark(consumer_.runner);
  } else if (way_ == Way::kModelled) {
    local_.push(message);
  } else if (way_ == Way::kAcross) {
    ring_.stage(message);
    if (policy_ == Policy::kBlock) return Recorder::kAtEnd;
    const int64_t now_ns = clock_.now_ns();
    publish(now_ns);
    return now_ns;
  } else {
    ipc::Message sent = message;
    sent.number = sent_;
    sent.sent_ns = clock_.now_ns();
    evicting_.push(sent);
    tell_of_message();
    return sent.sent_ns;
  }
  return Recorder::kAtEnd;
}

void Edge::publish_staged(int64_t now_ns) {
  ring_.for_staged([now_ns](ipc::Message& message) { message.sent_ns = now_ns; });
  ring_.publish();
  tell_of_message();
}

void Edge::tell_of_message() {
  if (waits_->message.take()) consumer_.doorbell->ring(bell_of(consumer_.runner));
}

/// How many had to go.
size_t Edge::evict_to(size_t kept, const char* reason) {
  ipc::Message taken;
  size_t count = 0;
  for (; queued() > kept; ++count) {
    if (way_ <= Way::kModelled) {
      taken = *local_.front();
      local_.pop();
      ++taken_;
    } else if (!evicting_.pop(taken)) {
      break;  // the consumer was faster
    }
    drop(taken, reason);
  }
  return count;
}

void Edge::drop(const ipc::Message& message, const char* reason) {
  if (message.kind != ipc::MessageKind::kFrame) return;
  full_.add();
  dropped_.add(reason);
  if (producer_recorder_) producer_recorder_->edge_dropped(number_, reason);
  Frame(message, *producer_.holder).release();
}

const ipc::Message* Edge::oldest() {
  switch (way_) {
    case Way::kLocal:
      return local_.front();
    case Way::kModelled:
      return local_.front() && !next_arrival_ns() ? local_.front() : nullptr;
    case Way::kAcross:
      return ring_.front();
    case Way::kEvicting:
      if (!claimed_) claimed_ = evicting_.pop(claim_);
      return claimed_ ? &claim_ : nullptr;
  }
  return nullptr;
}

const ipc::Message* Edge::front_elsewhere() {
  const ipc::Message* found = oldest();
  if (way_ == Way::kModelled) return found;
  if (!found) {
    waits_->message.set();
    found = oldest();
  }
  awaits_ = !found;
  return found;
}

/// A message may have been sent after the consumer's core has looked at the clock.
void Edge::record_taken(int64_t now_ns) {
  const ipc::Message& taken = *oldest();
  if (taken.kind == ipc::MessageKind::kEnd) return;
  taken_ = way_ == Way::kEvicting ? taken.number : taken_ + 1;
  const bool is_frame = taken.kind == ipc::MessageKind::kFrame;
  consumer_recorder_->taken(number_, taken_, is_frame, ipc() ? std::max(now_ns, taken.sent_ns) : now_ns);
}

void Edge::pop(int64_t now_ns) {
  if (consumer_recorder_) record_taken(now_ns);
  if (way_ == Way::kLocal) {
    local_.pop();
    if (std::exchange(wants_room_, false)) producer_.attention->mark(producer_.runner);
    return;
  }
  if (const ipc::Message& taken = *oldest(); taken.kind == ipc::MessageKind::kFrame)
    hop_.record(now_ns - taken.sent_ns);
  if (way_ == Way::kModelled) {
    local_.pop();
    producer_.attention->mark(producer_.runner);
    return;
  }
  if (way_ == Way::kEvicting) {
    claimed_ = false;
    return;
  }
  ring_.pop();
  if (waits_->room.take()) producer_.doorbell->ring(bell_of(producer_.runner));
}

void Edge::hand_over(int64_t now_ns) {
  leaving_.swap(held_back_);
  for (ipc::Message& message : leaving_) {
    message.sent_ns = now_ns;
    if (message.kind == ipc::MessageKind::kEnd) {
      late() == 0 ? void(push(message)) : hold_up(message, 0);
    } else {
      leave(message);
      high_water_ = std::max(high_water_, local_.size());
    }
  }
  leaving_.clear();
  tell_if_arrived();
}

std::optional<int64_t> Edge::next_arrival_ns() const {
  const ipc::Message* next = local_.front();
  if (!next || next->sent_ns + latency_ns_ <= clock_.now_ns()) return std::nullopt;
  return next->sent_ns + latency_ns_;
}

void Edge::tell_if_arrived() {
  if (oldest()) consumer_.attention->mark(consumer_.runner);
}

bool Edge::arrived() {
  if (!awaits_ || !oldest()) return false;
  awaits_ = false;
  return true;
}

}  // namespace svchain
