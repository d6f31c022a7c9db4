#pragma once
// What goes wrong in a source (a camera) on one of its outputs: pictures that freeze or come damaged, time
// stamps that are off. Belongs to the source's core.

#include "framework/buffer/frame.h"
#include "framework/buffer/pool.h"
#include "framework/fault/fault_site.h"

namespace svchain {

class SourceFaults {
 public:
  /// `spare`: has buffers beyond what the chain needs, for a damaged copy; null where no picture is damaged.
  SourceFaults(FaultSite& site, Pool* spare, bool pixels) : site_(site), spare_(spare), pixels_(pixels) {}

  /// What leaves the source instead of this frame.
  Frame instead_of(Frame&& frame);
  /// Lets go of the picture kept from when the source froze.
  void release() { frozen_.release(); }

 private:
  Frame frozen(Frame&& frame);
  Frame damaged(Frame&& frame) const;

  FaultSite& site_;
  Pool* spare_;
  bool pixels_;
  Frame frozen_;
};

}  // namespace svchain
