#pragma once
// Links that misbehave, to be put into chains that must bear it.

#include "framework/link/catalogue.h"

namespace svchain::testing {

/// "camera_fault": frames of one camera on their way to sync. Loses those of a range, sends some twice,
/// shifts time stamps by turns. "thrower": hands frames on and throws at one of them. "slow": hands frames
/// on, taking its time.
void add_faulty_links(Catalogue& catalogue);

}  // namespace svchain::testing
