#pragma once
// What crosses from core to core: never pixels, never a pointer, only which buffers of which pools and what
// is known of them. Fixed size, trivially copyable, the same in every process that maps the region.

#include <array>
#include <cstdint>
#include <type_traits>

namespace svchain::ipc {

struct BufferId {
  uint16_t pool = 0;
  uint16_t index = 0;
  bool operator==(const BufferId&) const = default;
};

/// The most buffers one frame carries (a set of eight cameras).
constexpr int kMaxBuffers = 8;

enum class MessageKind : uint8_t {
  kFrame,
  kAbsence,  // the frame of this sequence was lost upstream: joins and feedback loops go on without it
  kEnd,      // nothing follows
};

struct Message {
  uint64_t sequence = 0;
  int64_t captured_ns = 0;  // by the chain's clock, for latency
  int64_t sent_ns = 0;      // by the chain's clock, for hop time
  MessageKind kind = MessageKind::kFrame;
  uint8_t count = 0;  // buffers carried; a place in a set whose buffer is missing has kNoBuffer
  uint16_t lost_at = 0;  // of an absence: the place that has counted the loss, if it has said so
  uint32_t number = 0;  // where some are taken back: which message of its edge, from 1
  std::array<BufferId, kMaxBuffers> buffers{};
  std::array<int64_t, kMaxBuffers> timestamp_ns{};  // each buffer's own source time
};

constexpr BufferId kNoBuffer{0xffff, 0xffff};

static_assert(sizeof(Message) == 128 && std::is_trivially_copyable_v<Message>);

}  // namespace svchain::ipc
