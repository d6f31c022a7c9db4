#pragma once
// An edge at run time: a bounded ring of messages from one link to another, and what to do when it is full.
// Between two links of one core it is just that; between cores it is an IPC pair: who puts a message where
// none was, or takes one where there was no room, rings the other's doorbell.
//
// Thread rule: the functions of the producer on its core, those of the consumer on its core.

#include <string>

#include "framework/buffer/frame.h"
#include "framework/buffer/holder.h"
#include "framework/clock/clock.h"
#include "framework/statistics/counter.h"
#include "framework/statistics/drop_counts.h"
#include "framework/usecase/use_case.h"
#include "ipc/message.h"
#include "ipc/shared_region.h"

namespace svchain {

class Edge {
 public:
  /// One side of an edge: whom to tell that something has changed.
  struct End {
    int core = 0;
    int runner = 0;                     // on that core
    Attention* attention = nullptr;     // same core
    ipc::Doorbell* doorbell = nullptr;  // other core
    Holder* holder = nullptr;
  };

  Edge(std::string name, int depth, Policy policy, const End& producer, const End& consumer,
       const Clock& clock);

  const std::string& name() const { return name_; }
  bool ipc() const { return ipc_; }
  int depth() const { return depth_; }
  const End& producer() const { return producer_; }
  const End& consumer() const { return consumer_; }
  /// An edge into a kState input, where a lost frame need not leave its absence.
  void set_wants_absence(bool wants) { wants_absence_ = wants; }
  bool wants_absence() const { return wants_absence_; }

  // Producer:
  /// Frames that can be sent now. An edge that may drop always has room.
  int room() const;
  void send(ipc::Message message);
  /// The end always finds a place.
  void send_end();
  void note_full() { full_.add(); }

  // Consumer:
  bool peek(ipc::Message& message) const { return ring_.peek(message); }
  bool take(ipc::Message& message);
  size_t waiting() const { return ring_.size(); }

  uint64_t messages() const { return messages_.value(); }
  /// Times the producer found no room (kBlock), or frames that were dropped for want of it.
  uint64_t full() const { return full_.value(); }
  const DropCounts& dropped() const { return dropped_; }
  const Histogram& hop() const { return hop_; }

 private:
  void push(const ipc::Message& message);
  void drop(const ipc::Message& message, const char* reason);
  void evict_to(size_t kept, const char* reason);
  void tell(const End& end);

  std::string name_;
  int depth_;
  Policy policy_;
  End producer_, consumer_;
  const Clock& clock_;
  bool ipc_;
  bool wants_absence_ = true;
  ipc::SharedRegion region_;
  ipc::Ring<ipc::Message> ring_;
  Counter messages_, full_;
  DropCounts dropped_;
  Histogram hop_;
};

}  // namespace svchain
