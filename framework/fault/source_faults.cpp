#include "framework/fault/source_faults.h"

#include <cstring>
#include <utility>

namespace svchain {

namespace {

/// -1 to 1.
double either_way(uint64_t seed, uint64_t occasion) {
  return 2 * chance_of(seed, occasion) - 1;
}

/// The lower part, from a row that chance picks on: as when a transfer breaks off.
void fill_with_noise(std::span<std::byte> bytes, uint64_t sequence) {
  const double intact = chance_of(sequence, 0);
  const auto from = static_cast<size_t>(intact * static_cast<double>(bytes.size()));
  uint64_t noise = sequence * 2 + 1;
  for (size_t i = from; i < bytes.size(); ++i) {
    noise = noise * 6364136223846793005u + 1442695040888963407u;
    bytes[i] = static_cast<std::byte>(noise >> 56);
  }
}

void shift_times(Frame& frame, int64_t by_ns) {
  for (int buffer = 0; buffer < frame.count(); ++buffer)
    frame.set_timestamp_ns(buffer, frame.timestamp_ns(buffer) + by_ns);
}

}  // namespace

Frame SourceFaults::instead_of(Frame&& frame) {
  const uint64_t sequence = frame.sequence();
  if (const PlannedFault* jitter = site_.strike(FaultKind::kJitter, sequence)) {
    const double part = either_way(static_cast<uint64_t>(jitter->from_ns), sequence);
    shift_times(frame, static_cast<int64_t>(part * static_cast<double>(jitter->amount_ns)));
  }
  if (const PlannedFault* shift = site_.strike(FaultKind::kWrongTimestamp, sequence))
    shift_times(frame, shift->amount_ns);
  if (!site_.in_force(FaultKind::kFreeze)) {
    frozen_.release();
  } else if (site_.strike(FaultKind::kFreeze, sequence)) {
    frame = frozen(std::move(frame));
  }
  if (spare_ && site_.strike(FaultKind::kCorrupt, sequence)) return damaged(std::move(frame));
  return std::move(frame);
}

/// The picture from when it began, with the new times.
Frame SourceFaults::frozen(Frame&& frame) {
  if (!frozen_) frozen_ = frame.share();
  Frame again = frozen_.share();
  again.set_sequence(frame.sequence());
  again.set_captured_ns(frame.captured_ns());
  for (int buffer = 0; buffer < again.count(); ++buffer)
    again.set_timestamp_ns(buffer, frame.timestamp_ns(buffer));
  return again;
}

/// A copy: others may be looking at the picture. As it is where there is no buffer for that.
Frame SourceFaults::damaged(Frame&& frame) const {
  Holder& holder = *frame.holder();
  ipc::Message message = frame.message();
  for (size_t i = 0; i < message.count; ++i) {
    const auto index = holder.has_free(*spare_) ? spare_->take() : std::nullopt;
    if (!index) {
      message.count = static_cast<uint8_t>(i);
      Frame(message, holder).release();
      return std::move(frame);
    }
    message.buffers[i] = {spare_->id(), *index};
  }
  Draft copy{Frame(message, holder)};
  for (int buffer = 0; pixels_ && buffer < frame.count(); ++buffer) {
    const std::span<const std::byte> seen = frame.bytes(buffer);
    std::memcpy(copy.bytes(buffer).data(), seen.data(), seen.size());
    fill_with_noise(copy.bytes(buffer), frame.sequence() + static_cast<uint64_t>(buffer));
  }
  return std::move(copy).publish();
}

}  // namespace svchain
