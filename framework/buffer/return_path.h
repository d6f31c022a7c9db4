#pragma once
// How buffers get home: the rings of returns that leave a core, one for every core that owns pools, and those
// that come to it. Nobody is told of a return but an owner that waits for one; others find it when they look,
// which is when they would otherwise use a buffer more than ever before. Its core's thread only.

#include <memory>
#include <vector>

#include "framework/buffer/pool.h"
#include "ipc/doorbell.h"
#include "ipc/ring.h"

namespace svchain {

/// A buffer on its way back to its pool's owner.
struct ReturnedBuffer {
  ipc::BufferId buffer;
  uint32_t reserved = 0;
};
static_assert(sizeof(ReturnedBuffer) == 8);

using PoolTable = std::vector<std::unique_ptr<Pool>>;

class ReturnPath {
 public:
  struct Way {
    ipc::Ring<ReturnedBuffer> ring;  // holds as many as the owner has buffers: never full
    ipc::Doorbell* doorbell = nullptr;
  };
  explicit ReturnPath(int core) : core_(core) {}
  /// To the core `owner`.
  void add_way(int owner, const Way& way);
  void add_arrivals(ipc::Ring<ReturnedBuffer> ring) { arrivals_.push_back(ring); }

  void give_back(Pool& pool, uint16_t index);
  /// Puts what has come home into its pools.
  void collect(const PoolTable& pools);

 private:
  int core_;
  std::vector<Way> ways_;  // by core; none to itself
  std::vector<ipc::Ring<ReturnedBuffer>> arrivals_;
};

}  // namespace svchain
