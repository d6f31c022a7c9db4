#pragma once
// Cars from files: Wavefront OBJ (.obj with its .mtl) and glTF 2.0 (.gltf, .glb). Factors and vertex colours
// are used, textures are not. Any thread.

#include <filesystem>

#include "algorithms/car/car_model.h"
#include "algorithms/json/fault.h"

namespace svchain::car {

enum class Axis { kPlusX, kMinusX, kPlusY, kMinusY, kPlusZ, kMinusZ };

/// Where the front and the top of the car are in the file's own frame.
struct Orientation {
  Axis forward = Axis::kPlusZ;  // glTF's convention, and that of most OBJ files
  Axis up = Axis::kPlusY;
};

inline constexpr size_t kMostTriangles = 2'000'000;
inline constexpr uintmax_t kLargestFile = 256u << 20;  // bytes, a model's other files included

/// The model turned into the vehicle's axes, in the file's own size and place: fit_to() does the rest. What
/// is made of materials with an opacity below 1, with glTF's alphaMode BLEND, or called glass or window, is
/// translucent (at most 0.62 opaque where only the name says so). A corner without a normal gets one from the
/// planes around it. Faults name the file: missing, no model, nothing to see, coordinates that are no
/// numbers, indices out of range, too large.
Result<CarModel> read_car_model(const std::filesystem::path& path, const Orientation& orientation = {});

}  // namespace svchain::car
