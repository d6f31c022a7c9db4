#pragma once
// What every command that runs a chain does: get the libraries ready, settle the pace, configure, and run to
// the end under the host's loop. The controlling thread's.

#include <string>

#include "framework/chain/chain.h"
#include "usecases/svchain/host_loop.h"
#include "usecases/svchain/run_numbers.h"

namespace svchain::program {

/// The log goes to stderr, and OpenCV gets no threads: they would fight the cores'.
void prepare_libraries();

/// The pace of the numbers, completed by what the input is.
Pace pace_for(const std::string& input, const RunNumbers& numbers, Faults& faults);

/// Adds what is wrong with the links, and with the rig where no link has looked at it.
void configure(Chain& chain, Faults& faults);

/// Whether that went well, Chain::failure() tells. What the links warn of is logged: what they know at once
/// before the first frame, the rest at the end.
void run_to_its_end(Chain& chain, HostLoop& host, const RunNumbers& numbers, const Pace& pace);

void warn_of_outstanding_buffers(const Chain& chain);

}  // namespace svchain::program
