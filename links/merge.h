#pragma once
// Link "merge": frames of up to four inputs that carry the same sequence number become one set, with the
// buffers in the order of the inputs. What has no counterpart is dropped and counted.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_merge();

}  // namespace svchain
