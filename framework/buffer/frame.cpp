#include "framework/buffer/frame.h"

#include <cassert>

namespace svchain {

const Format& Frame::format(int buffer) const {
  return holder_->pool(message_.buffers[static_cast<size_t>(buffer)]).format();
}

std::span<const std::byte> Frame::bytes(int buffer) const {
  const ipc::BufferId id = message_.buffers[static_cast<size_t>(buffer)];
  return holder_->pool(id).bytes(id.index);
}

void Frame::append(Frame&& other) {
  if (message_.count == 0) {
    *this = std::move(other);
    return;
  }
  if (!holder_) {  // only missing members so far: nothing of their moment is known
    holder_ = other.holder_;
    message_.sequence = other.message_.sequence;
    message_.captured_ns = other.message_.captured_ns;
  }
  assert(message_.count + other.message_.count <= ipc::kMaxBuffers);
  for (size_t i = 0; i < other.message_.count; ++i) {
    message_.buffers[message_.count] = other.message_.buffers[i];
    message_.timestamp_ns[message_.count] = other.message_.timestamp_ns[i];
    ++message_.count;
  }
  other.message_.count = 0;
  other.holder_ = nullptr;
}

void Frame::append_missing() {
  assert(message_.count < ipc::kMaxBuffers);
  message_.buffers[message_.count] = ipc::kNoBuffer;
  message_.timestamp_ns[message_.count] = 0;
  ++message_.count;
}

Frame Frame::part(int buffer) const {
  ipc::Message message = message_;
  message.count = 1;
  message.buffers[0] = message_.buffers[static_cast<size_t>(buffer)];
  message.timestamp_ns[0] = message_.timestamp_ns[static_cast<size_t>(buffer)];
  Frame frame(message, *holder_);
  frame.add_references();
  return frame;
}

Frame Frame::share() const {
  if (!holder_) return {};
  add_references();
  return Frame(message_, *holder_);
}

void Frame::add_references() const {
  for_each_buffer([&](ipc::BufferId b) { holder_->pool(b).add_reference(b.index); });
}

void Frame::drop_references() {
  for_each_buffer([&](ipc::BufferId b) { holder_->drop_reference(b); });
  message_.count = 0;
  holder_ = nullptr;
}

std::span<std::byte> Draft::bytes(int buffer) {
  const ipc::BufferId id = frame_.message().buffers[static_cast<size_t>(buffer)];
  return frame_.holder()->pool(id).bytes(id.index);
}

}  // namespace svchain
