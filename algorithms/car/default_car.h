#pragma once
// A car that the program makes by itself, so that no model need be had: a saloon with wheels, windows, lights
// and seats, about 15,000 triangles. Any thread.

#include "algorithms/car/car_model.h"

namespace svchain::car {

/// Fills the vehicle's rectangle but for the mirrors, which stand out at the sides. Lengths and heights have
/// one scale, so that wheels are round; widths their own.
CarModel default_car(const geometry::Vehicle& vehicle);

}  // namespace svchain::car
