#pragma once
// Frame: a shared, const handle on one to eight buffers of one moment (an image, a set of four, a table).
// Draft: the same while its one writer still writes it. Handles are counted: the last one to go sends the
// buffers back to their pool. Thread rule: a handle belongs to the core (thread) of its holder; frames cross
// cores only through edges.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "framework/buffer/format.h"
#include "framework/buffer/holder.h"
#include "ipc/message.h"

namespace svchain {

class Frame {
 public:
  Frame() = default;
  /// Takes over the references that the message carries.
  Frame(const ipc::Message& message, Holder& holder) : message_(message), holder_(&holder) { arrive(); }
  Frame(Frame&& other) noexcept : message_(other.message_), holder_(std::exchange(other.holder_, nullptr)) {
    other.message_.count = 0;
  }
  Frame& operator=(Frame&& other) noexcept {
    if (this != &other) {
      release();
      message_ = other.message_;
      holder_ = std::exchange(other.holder_, nullptr);
      other.message_.count = 0;
    }
    return *this;
  }
  ~Frame() { release(); }
  /// Becomes the frame of a message, and takes over the references that it carries.
  void receive(const ipc::Message& message, Holder& holder) {
    release();
    message_ = message;
    holder_ = &holder;
    arrive();
  }

  /// True if it carries buffers.
  explicit operator bool() const { return holder_ != nullptr && message_.count > 0; }

  uint64_t sequence() const { return message_.sequence; }
  int count() const { return message_.count; }
  /// False for a place in a set whose camera gave nothing.
  bool has(int buffer) const { return message_.buffers[static_cast<size_t>(buffer)] != ipc::kNoBuffer; }
  int64_t timestamp_ns(int buffer = 0) const { return message_.timestamp_ns[static_cast<size_t>(buffer)]; }
  int64_t captured_ns() const { return message_.captured_ns; }
  const Format& format(int buffer = 0) const;
  std::span<const std::byte> bytes(int buffer = 0) const;

  void set_sequence(uint64_t sequence) { message_.sequence = sequence; }
  void set_captured_ns(int64_t t) { message_.captured_ns = t; }
  void set_timestamp_ns(int buffer, int64_t t) { message_.timestamp_ns[static_cast<size_t>(buffer)] = t; }

  /// Moves the buffers of another frame into this one, behind those it has; the first one also gives sequence
  /// and capture time. A set whose member is missing gets append_missing().
  void append(Frame&& other);
  void append_missing();
  /// A frame of only this buffer of the set.
  Frame part(int buffer) const;
  /// Another handle on the same buffers.
  Frame share() const;
  void release() {
    if (holder_) drop_references();
  }

  const ipc::Message& message() const { return message_; }
  Holder* holder() const { return holder_; }
  /// Gives the references up to whoever has taken the message (an edge).
  void hand_over() {
    if (holder_) for_each_buffer([&](ipc::BufferId b) { holder_->left(b); });
    message_.count = 0;
    holder_ = nullptr;
  }

 private:
  /// The buffers that it really carries.
  template <class Do>
  void for_each_buffer(Do&& with) const {
    for (size_t i = 0; i < message_.count; ++i) {
      if (message_.buffers[i] != ipc::kNoBuffer) with(message_.buffers[i]);
    }
  }
  void arrive() {
    for_each_buffer([&](ipc::BufferId b) { holder_->arrived(b); });
  }
  void add_references() const;
  void drop_references();

  ipc::Message message_;
  Holder* holder_ = nullptr;
};

class Draft {
 public:
  Draft() = default;
  explicit Draft(Frame&& frame) : frame_(std::move(frame)) {}
  explicit operator bool() const { return static_cast<bool>(frame_); }

  const Format& format(int buffer = 0) const { return frame_.format(buffer); }
  std::span<std::byte> bytes(int buffer = 0);
  void set_sequence(uint64_t sequence) { frame_.set_sequence(sequence); }
  void set_captured_ns(int64_t t) { frame_.set_captured_ns(t); }
  void set_timestamp_ns(int64_t t) { frame_.set_timestamp_ns(0, t); }
  /// Ends the writing.
  Frame publish() && { return std::move(frame_); }

 private:
  Frame frame_;
};

}  // namespace svchain
