#pragma once
// Reading and writing each lens model (contracts: "Rig"), for the table in lens_json.cpp. Readers return null
// after a fault; writers are given a lens of their own model.

#include <nlohmann/json_fwd.hpp>

#include "algorithms/geometry/lens.h"
#include "algorithms/json/value.h"

namespace svchain::geometry {

LensPtr read_kannala_brandt(const json::Value& lens);
nlohmann::ordered_json write_kannala_brandt(const Lens& lens);
LensPtr read_polynomial(const json::Value& lens);
nlohmann::ordered_json write_polynomial(const Lens& lens);
LensPtr read_table(const json::Value& lens);
nlohmann::ordered_json write_table(const Lens& lens);
LensPtr read_ocam(const json::Value& lens);
nlohmann::ordered_json write_ocam(const Lens& lens);
LensPtr read_mei(const json::Value& lens);
nlohmann::ordered_json write_mei(const Lens& lens);
LensPtr read_eucm(const json::Value& lens);
nlohmann::ordered_json write_eucm(const Lens& lens);
LensPtr read_double_sphere(const json::Value& lens);
nlohmann::ordered_json write_double_sphere(const Lens& lens);
LensPtr read_pinhole(const json::Value& lens);
nlohmann::ordered_json write_pinhole(const Lens& lens);

}  // namespace svchain::geometry
