#include <sstream>
#include <tiny_obj_loader.h>

#include "algorithms/car/loose_model.h"
#include "algorithms/car/model_file.h"

namespace svchain::car {
namespace {

/// Reads the material files that the model names, from its folder.
class Materials : public tinyobj::MaterialReader {
 public:
  Materials(std::filesystem::path folder, uintmax_t room) : folder_(std::move(folder)), room_(room) {}

  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* numbers, std::string* warning, std::string* error) override {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(folder_ / name, ignored)) return false;  // it has no colours then
    const std::string bytes = read_bytes(folder_ / name, room_);
    room_ -= bytes.size();
    std::istringstream text(bytes);
    tinyobj::LoadMtl(numbers, materials, &text, warning, error);
    return true;
  }

 private:
  std::filesystem::path folder_;
  uintmax_t room_;
};

float share(float value) {
  return value >= 0 ? std::min(value, 1.0f) : 0.0f;
}

/// Phong's exponent as gloss: 1 at 1000.
float gloss(float shininess) {
  return share(std::log10(std::max(1.0f, shininess)) / 3) * 0.95f;
}

Material material_of(const tinyobj::material_t& m) {
  Material material{m.name,
                    {share(m.diffuse[0]), share(m.diffuse[1]), share(m.diffuse[2])},
                    share(m.dissolve),
                    gloss(m.shininess),
                    share(m.metallic)};
  if (m.roughness > 0) material.gloss = 1 - share(m.roughness);
  if (material.opaque() && names_glass(m.name)) material.opacity = kPaneOpacity;
  return material;
}

class Corners {
 public:
  explicit Corners(const tinyobj::attrib_t& attributes) : attributes_(attributes) {}

  Vertex at(const tinyobj::index_t& index) const {
    return {
        vector(attributes_.vertices, index.vertex_index),
        index.normal_index < 0 ? Eigen::Vector3f::Zero() : vector(attributes_.normals, index.normal_index)};
  }

 private:
  static Eigen::Vector3f vector(const std::vector<float>& values, int index) {
    if (index < 0 || static_cast<size_t>(index) >= values.size() / 3)
      throw ModelError{"has a face with an index out of range: " + std::to_string(index + 1) +
                       "; expected 1 to " + std::to_string(values.size() / 3)};
    const Eigen::Vector3f v(values[3 * index], values[3 * index + 1], values[3 * index + 2]);
    check_finite(v);
    return v;
  }
  const tinyobj::attrib_t& attributes_;
};

/// The library reads what is no number as 0 and "nan" as one.
void check_text(const std::string& bytes) {
  if (bytes.find('\0') != std::string::npos)
    throw ModelError{"is not a model: expected the text of an OBJ file"};
}

}  // namespace

LooseModel read_obj(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path, kLargestFile);
  check_text(bytes);
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream text(bytes);
  Materials reader(path.parent_path(), kLargestFile - bytes.size());
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &text, &reader, true, false))
    throw ModelError{"is not a model: " + error};

  LooseModel model;
  for (const tinyobj::material_t& material : materials) model.materials.push_back(material_of(material));
  const auto plain = static_cast<uint32_t>(materials.size());
  model.materials.push_back({"plain", {0.5f, 0.5f, 0.5f}, 1, 0.5f, 0});
  const Corners corners(attributes);
  for (const tinyobj::shape_t& shape : shapes) {
    check_count(model.triangles.size() + shape.mesh.indices.size() / 3);
    for (size_t t = 0; t < shape.mesh.indices.size() / 3; ++t) {
      const auto* const i = &shape.mesh.indices[3 * t];
      const int number = shape.mesh.material_ids[t];
      const bool known = number >= 0 && static_cast<size_t>(number) < materials.size();
      model.triangles.push_back({{corners.at(i[0]), corners.at(i[1]), corners.at(i[2])},
                                 known ? static_cast<uint32_t>(number) : plain});
    }
  }
  if (model.triangles.empty()) throw ModelError{"has no triangles; expected the faces of an OBJ file"};
  return model;
}

}  // namespace svchain::car
