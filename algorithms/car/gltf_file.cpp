#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <map>
#include <tiny_gltf.h>

#include "algorithms/car/gltf_values.h"
#include "algorithms/car/loose_model.h"
#include "algorithms/car/model_file.h"

namespace svchain::car {
namespace {

constexpr int kDeepestNode = 64;
constexpr int kMostNodes = 100000;
constexpr int kDeepestValue = 100;
constexpr float kColourSteps = 15;  // that vertex colours are told apart by

/// Deep nesting would exhaust the library's stack.
void check_nesting(std::string_view json) {
  int depth = 0;
  bool quoted = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '{' || c == '[') && ++depth > kDeepestValue) {
      throw ModelError{"is not a model: its JSON is nested too deeply"};
    } else if (!quoted && (c == '}' || c == ']')) {
      --depth;
    }
  }
}

std::string_view json_of_binary(std::string_view bytes) {
  constexpr size_t kHeader = 20;
  uint32_t length = 0;
  if (bytes.size() < kHeader || !bytes.starts_with("glTF"))
    throw ModelError{"is not a model: expected the header of a binary glTF file"};
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return bytes.substr(kHeader, length);
}

/// Reads buffers that lie in files of their own; what is left of the room stands behind `room`.
bool read_beside(std::vector<unsigned char>* bytes, std::string* error, const std::string& path, void* room) {
  try {
    const std::string content = read_bytes(path, *static_cast<uintmax_t*>(room));
    *static_cast<uintmax_t*>(room) -= content.size();
    bytes->assign(content.begin(), content.end());
    return true;
  } catch (const ModelError& fault) {
    if (error) *error += fault.message;
    return false;
  }
}

tinygltf::Model parse(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path, kLargestFile);
  const bool binary = bytes.starts_with("glTF") || path.extension() == ".glb";
  check_nesting(binary ? json_of_binary(bytes) : std::string_view(bytes));

  uintmax_t room = kLargestFile - bytes.size();
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(
      {&tinygltf::FileExists, &tinygltf::ExpandFilePath, &read_beside, &tinygltf::WriteWholeFile, &room});
  reader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
                           int, void*) { return true; },
                        nullptr);
  tinygltf::Model document;
  std::string error, warning;
  const auto size = static_cast<unsigned int>(bytes.size());
  const std::string folder = path.parent_path().string();
  const bool read =
      binary ? reader.LoadBinaryFromMemory(&document, &error, &warning,
                                           reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
             : reader.LoadASCIIFromString(&document, &error, &warning, bytes.data(), size, folder);
  while (!error.empty() && error.back() == '\n') error.pop_back();
  if (!read) throw ModelError{"is not a model: " + error};
  return document;
}

float share(double value) {
  return value >= 0 ? static_cast<float>(std::min(value, 1.0)) : 0.0f;
}

Material material_of(const tinygltf::Material& m) {
  const tinygltf::PbrMetallicRoughness& factors = m.pbrMetallicRoughness;
  Material material{
      m.name, {0.5f, 0.5f, 0.5f}, 1, 1 - share(factors.roughnessFactor), share(factors.metallicFactor)};
  const std::vector<double>& colour = factors.baseColorFactor;
  if (colour.size() >= 3) material.base_colour = {share(colour[0]), share(colour[1]), share(colour[2])};
  const bool blended = m.alphaMode == "BLEND";
  if (blended && colour.size() == 4) material.opacity = share(colour[3]);
  if (material.opaque() && (blended || names_glass(m.name))) material.opacity = kPaneOpacity;
  return material;
}

class Reader {
 public:
  explicit Reader(const tinygltf::Model& document) : document_(document) {
    for (const tinygltf::Material& material : document.materials)
      model_.materials.push_back(material_of(material));
    model_.materials.push_back({"plain", {0.5f, 0.5f, 0.5f}, 1, 0.5f, 0});
    plain_ = static_cast<uint32_t>(document.materials.size());
  }

  /// A node's meshes and its children's.
  void add_node(int number, const Eigen::Matrix4d& parent, int depth) {
    if (number < 0 || static_cast<size_t>(number) >= document_.nodes.size())
      throw ModelError{"refers to node " + std::to_string(number) + ", an index out of range"};
    if (depth > kDeepestNode || ++nodes_ > kMostNodes) throw ModelError{"has nodes within nodes without end"};
    const tinygltf::Node& node = document_.nodes[number];
    const Eigen::Matrix4d file_from_node = parent * transform(node);
    if (node.mesh >= 0) add_mesh(node.mesh, file_from_node);
    for (const int child : node.children) add_node(child, file_from_node, depth + 1);
  }

  LooseModel take() { return std::move(model_); }

 private:
  static Eigen::Matrix4d transform(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    Eigen::Affine3d motion = Eigen::Affine3d::Identity();
    if (node.translation.size() == 3) motion.translate(Eigen::Vector3d::Map(node.translation.data()));
    if (node.rotation.size() == 4)
      motion.rotate(Eigen::Quaterniond(Eigen::Vector4d::Map(node.rotation.data())).normalized());
    if (node.scale.size() == 3) motion.scale(Eigen::Vector3d(Eigen::Vector3d::Map(node.scale.data())));
    return motion.matrix();
  }

  void add_mesh(int number, const Eigen::Matrix4d& file_from_node) {
    if (static_cast<size_t>(number) >= document_.meshes.size())
      throw ModelError{"refers to mesh " + std::to_string(number) + ", an index out of range"};
    for (const tinygltf::Primitive& primitive : document_.meshes[number].primitives)
      add_primitive(primitive, file_from_node);
  }

  void add_primitive(const tinygltf::Primitive& primitive, const Eigen::Matrix4d& file_from_node) {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end() || mode < TINYGLTF_MODE_TRIANGLES) return;  // points and lines
    std::vector<Vertex> vertices = vertices_of(primitive, position->second, file_from_node);

    const bool coloured = primitive.attributes.contains("COLOR_0");
    const GltfValues colour(document_, coloured ? primitive.attributes.at("COLOR_0") : position->second);
    const uint32_t material = primitive.material >= 0 && static_cast<uint32_t>(primitive.material) < plain_
                                  ? static_cast<uint32_t>(primitive.material)
                                  : plain_;

    const std::vector<uint32_t> order = indices_of(primitive, vertices.size());
    const size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    check_count(model_.triangles.size() + order.size() / step);
    const bool mirrored = file_from_node.topLeftCorner<3, 3>().determinant() < 0;
    for (size_t i = 0; i + 2 < order.size(); i += step) {
      std::array<uint32_t, 3> corners = {order[i], order[i + 1], order[i + 2]};
      if (mode == TINYGLTF_MODE_TRIANGLE_FAN) corners[0] = order[0];
      const bool odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
      if (odd != mirrored) std::swap(corners[1], corners[2]);
      const uint32_t tinted = coloured ? tinted_material(material, colour, corners[0]) : material;
      model_.triangles.push_back(
          {{vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]}, tinted});
    }
  }

  std::vector<Vertex> vertices_of(const tinygltf::Primitive& primitive, int position,
                                  const Eigen::Matrix4d& file_from_node) const {
    const GltfValues positions(document_, position);
    const auto normal = primitive.attributes.find("NORMAL");
    const GltfValues normals(document_, normal == primitive.attributes.end() ? position : normal->second);
    const bool has_normals = normal != primitive.attributes.end() && normals.count() >= positions.count();
    // Planes turn with the inverse transpose, here times the determinant's size.
    const Eigen::Matrix3d m = file_from_node.topLeftCorner<3, 3>();
    Eigen::Matrix3d planes;
    planes << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
    if (m.determinant() < 0) planes = -planes;

    std::vector<Vertex> vertices;
    for (size_t i = 0; i < positions.count(); ++i) {
      const Eigen::Vector4d p = positions.vector(i).head<3>().cast<double>().homogeneous();
      Vertex vertex{(file_from_node * p).head<3>().cast<float>(), Eigen::Vector3f::Zero()};
      check_finite(vertex.position);
      if (has_normals) {
        vertex.normal = (planes * normals.vector(i).head<3>().cast<double>()).normalized().cast<float>();
        if (!vertex.normal.allFinite()) vertex.normal.setZero();
      }
      vertices.push_back(vertex);
    }
    return vertices;
  }

  std::vector<uint32_t> indices_of(const tinygltf::Primitive& primitive, size_t vertices) const {
    std::vector<uint32_t> order;
    if (primitive.indices < 0) {
      for (uint32_t i = 0; i < vertices; ++i) order.push_back(i);
      return order;
    }
    const GltfValues values(document_, primitive.indices);
    for (size_t i = 0; i < values.count(); ++i) {
      const uint32_t index = values.index(i);
      if (index >= vertices)
        throw ModelError{"has a triangle with an index out of range: " + std::to_string(index) +
                         "; expected less than " + std::to_string(vertices)};
      order.push_back(index);
    }
    return order;
  }

  /// The material times the colour of a triangle's first corner.
  uint32_t tinted_material(uint32_t material, const GltfValues& colours, uint32_t corner) {
    if (corner >= colours.count()) return material;
    std::array<int, 4> key = {static_cast<int>(material), 0, 0, 0};
    Material tinted = model_.materials[material];
    const Eigen::Vector4f colour = colours.vector(corner);
    for (int i = 0; i < 3; ++i) {
      key[i + 1] = static_cast<int>(share(colour[i]) * kColourSteps + 0.5f);
      tinted.base_colour[i] *= static_cast<float>(key[i + 1]) / kColourSteps;
    }
    const auto [entry, is_new] = tints_.try_emplace(key, static_cast<uint32_t>(model_.materials.size()));
    if (is_new) model_.materials.push_back(tinted);
    return entry->second;
  }

  const tinygltf::Model& document_;
  LooseModel model_;
  std::map<std::array<int, 4>, uint32_t> tints_;  // material and steps of red, green, blue
  uint32_t plain_ = 0;
  int nodes_ = 0;
};

/// The default scene's nodes, else the first scene's, else all that are nobody's children.
std::vector<int> roots(const tinygltf::Model& document) {
  if (!document.scenes.empty()) {
    const auto scene = static_cast<size_t>(std::max(0, document.defaultScene));
    if (scene >= document.scenes.size()) throw ModelError{"refers to a scene that it does not have"};
    return document.scenes[scene].nodes;
  }
  std::vector<bool> is_child(document.nodes.size(), false);
  for (const tinygltf::Node& node : document.nodes)
    for (const int child : node.children)
      if (child >= 0 && static_cast<size_t>(child) < is_child.size()) is_child[child] = true;
  std::vector<int> all;
  for (size_t i = 0; i < is_child.size(); ++i)
    if (!is_child[i]) all.push_back(static_cast<int>(i));
  return all;
}

}  // namespace

LooseModel read_gltf(const std::filesystem::path& path) {
  const tinygltf::Model document = parse(path);
  Reader reader(document);
  for (const int root : roots(document)) reader.add_node(root, Eigen::Matrix4d::Identity(), 0);
  LooseModel model = reader.take();
  if (model.triangles.empty()) throw ModelError{"has no triangles; expected the meshes of a glTF scene"};
  return model;
}

}  // namespace svchain::car
