#pragma once
// One call of a link's process(): its inputs, its outputs and its time. Valid during the call only. No
// function here allocates, locks or blocks.

#include <cstdint>

#include "framework/buffer/frame.h"

namespace svchain {

class Call {
 public:
  virtual ~Call() = default;

  /// The frame at an input; empty (false) where a kAny link has none there now, an optional input is
  /// unconnected, or the frame of a feedback input was lost: then the last one stays in force.
  virtual const Frame& input(int port) const = 0;
  /// Takes the frame away from the call, to keep or to send on.
  virtual Frame take(int port) = 0;

  /// A fresh frame for an output, to be written and sent. It carries the sequence and times of the call's
  /// first input.
  virtual Draft create(int port) = 0;
  /// Publishes a draft: from here on it is shared and const.
  virtual void send(int port, Draft&& draft) = 0;
  virtual void send(int port, Frame&& frame) = 0;
  /// Frames this output can take now.
  virtual int room(int port) const = 0;

  /// The chain's clock at the start of this call.
  virtual int64_t now_ns() const = 0;

  /// Counts a set (or, in a link that handles single frames, a frame) that ends here. `reason` must be a
  /// literal.
  virtual void drop(const char* reason, uint64_t count = 1) = 0;

  /// CPUs of the link's core that are there to share its work.
  virtual int cpus() const = 0;
  /// Runs part(0) ... part(count - 1) on all CPUs that the link's core has ("cpus"), in no particular order,
  /// and returns when all are done; on a core of one CPU, and by hand, one after the other. Parts may throw,
  /// and must not use the call.
  template <class Parts>
  void parallel(int count, const Parts& part) {
    run_parts(
        count, [](const void* parts, int i) { (*static_cast<const Parts*>(parts))(i); }, &part);
  }

  // For sources (links without inputs):
  /// Counts sets as captured, dropped ones too.
  virtual void captured(uint64_t sets = 1) = 0;
  /// Calls again not before this time. Without it, as soon as there is room.
  virtual void wake_at(int64_t time_ns) = 0;
  /// Nothing follows.
  virtual void end() = 0;

 protected:
  virtual void run_parts(int count, void (*part)(const void* context, int part), const void* context) = 0;
};

}  // namespace svchain
