#include "algorithms/geometry/lens_json.h"

#include <nlohmann/json.hpp>

#include "algorithms/geometry/lens_models.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

/// Every lens model there is. A new one adds its two functions to lens_models.h and its line here.
struct Model {
  std::string name;
  LensPtr (*read)(const json::Value&);
  ordered_json (*write)(const Lens&);
};

const std::vector<Model>& models() {
  static const std::vector<Model> kModels = {
      {"kannala_brandt", read_kannala_brandt, write_kannala_brandt},
      {"polynomial", read_polynomial, write_polynomial},
      {"table", read_table, write_table},
      {"ocam", read_ocam, write_ocam},
      {"mei", read_mei, write_mei},
      {"eucm", read_eucm, write_eucm},
      {"double_sphere", read_double_sphere, write_double_sphere},
      {"pinhole", read_pinhole, write_pinhole},
  };
  return kModels;
}

const Model* find_model(const std::string& name) {
  for (const auto& model : models()) {
    if (model.name == name) return &model;
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> lens_models() {
  std::vector<std::string> names;
  for (const auto& model : models()) names.push_back(model.name);
  return names;
}

LensPtr read_lens(const json::Value& lens) {
  const auto* model = find_model(lens.required("model").choice(lens_models()));
  return model ? model->read(lens) : nullptr;
}

ordered_json lens_json(const Lens& lens) {
  return find_model(lens.model())->write(lens);
}

}  // namespace svchain::geometry
