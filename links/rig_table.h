#pragma once
// A rig on its way from link to link, as the text of a rig file in a buffer of type "rig": calibration is
// done on one core, and whoever draws from it sits on another. Plain functions.

#include <cstddef>
#include <span>

#include "algorithms/geometry/rig.h"
#include "framework/buffer/format.h"

namespace svchain {

/// Room for any rig that differs from this one in its numbers.
Format rig_format(const geometry::Rig& rig);

/// Throws std::runtime_error where the room does not suffice.
void write_rig(const geometry::Rig& rig, std::span<std::byte> into);

/// Throws std::runtime_error with the faults of a text that is no rig.
geometry::Rig read_rig_table(std::span<const std::byte> from);

}  // namespace svchain
