#pragma once
// A row of premultiplied pixels laid over another, on vectors (Highway): out = car + (1 - alpha) out, rounded
// to nearest. `car` has four bytes a pixel, `bgr` three. Any thread; nothing allocates or throws.

#include <cstddef>
#include <cstdint>

namespace svchain::car {

void blend_row(const uint8_t* car, size_t count, uint8_t* bgr);

}  // namespace svchain::car
