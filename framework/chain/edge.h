#pragma once
// An edge at run time: a bounded ring of messages from one link to another, and what to do when it is full.
// Between two links of one core it is just that; between cores it is an IPC pair: who puts a message where
// the other has found none, or takes one where the other has found no room, rings the other's doorbell.
//
// What a call sends to another core leaves at the end of the call, all of it at the time that ends the call.
// (Edges that may drop send at once: what they drop depends on what the other core has taken.)
//
// In modelled time (modelled_time.h) one thread has both sides, and every edge, local ones too, hands over at
// the end of the call; its consumer sees that a latency later.
//
// A message that gets lost leaves its slot empty, which the consumer finds in its turn: an absence. A state
// that got lost can be asked for again.
//
// Thread rule: the functions of the producer on its core, those of the consumer on its core.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/buffer/attention.h"
#include "framework/buffer/holder.h"
#include "framework/chain/local_ring.h"
#include "framework/clock/clock.h"
#include "framework/fault/core_faults.h"
#include "framework/statistics/counter.h"
#include "framework/statistics/drop_counts.h"
#include "framework/trace/recorder.h"
#include "framework/usecase/use_case.h"
#include "ipc/evicting_ring.h"
#include "ipc/mark.h"
#include "ipc/message.h"
#include "ipc/ring.h"
#include "ipc/shared_region.h"

namespace svchain {

/// Why a set got lost, where it may have got lost on two ways at once.
inline constexpr const char *kLostOnEdge = "lost", *kLostInCall = "error";
/// Places that count such losses: links from 1 on, and edges from here on.
inline constexpr uint16_t kEdgePlaces = 0x8000;
inline bool is_lost_on_edge(uint16_t place) {
  return place >= kEdgePlaces;
}

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

  /// `modelled_latency_ns`: of an edge in modelled time.
  Edge(std::string name, int depth, Policy policy, const End& producer, const End& consumer,
       const Clock& clock, std::optional<int64_t> modelled_latency_ns = {});

  const std::string& name() const { return name_; }
  bool ipc() const { return producer_.core != consumer_.core; }
  int depth() const { return depth_; }
  const End& producer() const { return producer_; }
  const End& consumer() const { return consumer_; }
  /// An edge into a kState input, where a lost frame need not leave its absence.
  void set_wants_absence(bool wants) { wants_absence_ = wants; }
  bool wants_absence() const { return wants_absence_; }
  /// Traced, as `number`: by the recorders of the producer's core and the consumer's.
  void set_recorders(int number, Recorder& producer, Recorder& consumer);
  /// What goes wrong here, by the site, on the producer's core.
  /// `place`: what absences say of losses that are counted here; 0 where they are not.
  void set_faults(FaultSite& site, CoreFaults& core, uint16_t place);
  /// The most that wait here: one that could be taken back may be in the consumer's hand.
  int capacity() const { return depth_ + (way_ == Way::kEvicting ? 1 : 0); }

  // Producer:
  /// Frames that can be sent now. An edge that may drop always has room.
  int room();
  /// Whether one can be sent. If not, the producer's link will be looked at when there is room.
  bool has_room();
  void send(const ipc::Message& message);
  /// A state that has got lost.
  void send_again(const ipc::Message& message) {
    if (trouble_) ++trouble_->times_again;
    send(message);
  }
  /// The end always finds a place.
  void send_end();
  /// Ends a call: what it has sent leaves now.
  void publish(int64_t now_ns) {
    if (way_ == Way::kAcross && ring_.staged() > 0) publish_staged(now_ns);
  }
  void note_full() { full_.add(); }
  /// The consumer has asked for the newest state again. Once true, the request is taken.
  bool takes_request() { return waits_->state.take(); }
  /// A message that was sent since the last look has been lost to a fault.
  bool take_lost() { return trouble_ && std::exchange(trouble_->lost, false); }
  /// Messages that a fault has held up leave now if their time has come and there is room.
  void send_late(int64_t now_ns);
  /// Lets go of them all, the chain having stopped.
  void drop_late();

  // Consumer:
  /// The oldest message, which stays where it is until pop(). Null if there is none: then the consumer's link
  /// will be looked at when one comes.
  const ipc::Message* front() { return way_ == Way::kLocal ? local_.front() : front_elsewhere(); }
  /// Takes the front away, at `now_ns` by the chain's clock.
  void pop(int64_t now_ns);
  /// The newest state has got lost: asks for it again, unless something is on its way. True if it was asked
  /// for.
  bool request_newest();
  /// For a core that spins: a message has come since front() found none. True only once.
  bool arrived();

  // In modelled time:
  /// What the call that goes on has sent.
  const std::vector<ipc::Message>& held_back() const { return held_back_; }
  /// The same leaves now, the end of the call.
  void hand_over(int64_t now_ns);
  /// When the oldest message can be seen, if it cannot yet.
  std::optional<int64_t> next_arrival_ns() const;
  /// Has the consumer's link looked at, if there is a message that it can see.
  void tell_if_arrived();
  /// The most frames and absences that have waited here.
  size_t high_water() const { return high_water_; }

  uint64_t messages() const { return messages_.value(); }
  /// Times the producer found no room (kBlock), or frames that were dropped for want of it.
  uint64_t full() const { return full_.value(); }
  const DropCounts& dropped() const { return dropped_; }
  const Histogram& hop() const { return hop_; }

 private:
  /// How messages go: within a core; in modelled time; to another core; to another core that may find some
  /// taken back.
  enum class Way { kLocal, kModelled, kAcross, kEvicting };
  /// In the region, before the ring: who waits for the other side.
  struct Waits {
    ipc::Mark message, room, state;
  };
  struct Late {
    ipc::Message message;
    int64_t due_ns;
  };
  /// Of an edge in a run in which things break.
  struct Trouble {
    FaultSite& site;
    CoreFaults& core;
    uint16_t place;
    std::deque<Late> late = {};
    bool lost = false;
    uint64_t times_again = 0;
  };
  bool in_force(FaultKind kind) const { return trouble_ && trouble_->site.in_force(kind); }
  size_t late() const { return trouble_ ? trouble_->late.size() : 0; }

  size_t queued();
  int64_t push(const ipc::Message& message);
  void record_taken(int64_t now_ns);
  void leave(const ipc::Message& message);
  void leave_if_nothing_is_wrong(ipc::Message message);
  void lose(const ipc::Message& message, const char* reason);
  void hold_up(const ipc::Message& message, int64_t due_ns);
  void apply_policy(const ipc::Message& message);
  void drop(const ipc::Message& message, const char* reason);
  size_t evict_to(size_t kept, const char* reason);
  void publish_staged(int64_t now_ns);
  void tell_of_message();
  const ipc::Message* oldest();
  const ipc::Message* front_elsewhere();

  // What a hop within a core looks at comes first and close together; the same of the producer's.
  int depth_;
  Policy policy_;
  Way way_;
  bool wants_absence_ = true;
  End producer_, consumer_;
  LocalRing local_;  // of kModelled too
  const Clock& clock_;
  int number_ = 0;                                                        // for the recorders
  Recorder *producer_recorder_ = nullptr, *consumer_recorder_ = nullptr;  // null: not traced
  std::string name_;
  ipc::SharedRegion region_;          // of an edge between cores: Waits, then the ring
  std::unique_ptr<Waits> own_waits_;  // of an edge within one thread
  Waits* waits_ = nullptr;
  std::vector<ipc::Message> held_back_, leaving_;
  int64_t latency_ns_ = 0;
  size_t high_water_ = 0;
  ipc::Ring<ipc::Message> ring_;
  ipc::EvictingRing<ipc::Message> evicting_;
  // The producer's.
  alignas(ipc::kCacheLine) Counter messages_, full_;
  uint32_t sent_ = 0;                 // the number of the message sent last
  bool wants_room_ = false;           // kLocal: the producer has found none
  std::unique_ptr<Trouble> trouble_;  // null: nothing goes wrong here
  DropCounts dropped_;
  // The consumer's.
  alignas(ipc::kCacheLine) bool awaits_ = false;  // front() has found nothing
  bool claimed_ = false;                          // kEvicting: the front is out of the ring
  uint32_t taken_ = 0;                            // where it is traced: the message taken last
  ipc::Message claim_;
  Histogram hop_;
};

}  // namespace svchain
