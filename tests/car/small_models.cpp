#include "tests/car/small_models.h"

#include <cstring>
#include <fstream>
#include <iterator>

namespace svchain::testing {
namespace {

using car::LooseTriangle;

std::vector<LooseTriangle> box_triangles(const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  std::vector<LooseTriangle> triangles;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto corner = [&](bool at_u, bool at_v) {
        Eigen::Vector3f p = upper ? high : low;
        p[u] = at_u ? high[u] : low[u];
        p[v] = at_v ? high[v] : low[v];
        return car::Vertex{p, Eigen::Vector3f::Unit(axis) * (upper ? 1.0f : -1.0f)};
      };
      triangles.push_back({{corner(false, false), corner(true, false), corner(true, true)}, 0});
      triangles.push_back({{corner(false, false), corner(true, true), corner(false, true)}, 0});
    }
  return triangles;
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Six corners as floats, then six indices of 16 bits.
std::string gltf_buffer() {
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 0, 1, 2};
  const uint16_t indices[] = {0, 1, 2, 0, 1, 2};
  std::string bytes;
  for (const float corner : corners) append(bytes, corner);
  for (const uint16_t index : indices) append(bytes, index);
  return bytes;
}

std::string gltf_json(const std::string& buffer) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1],"translation":[0,1,0]},{"mesh":0,"scale":[2,2,2]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":2,"material":1},
{"attributes":{"POSITION":1},"indices":3,"material":0}]}],
"materials":[{"name":"pane","alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.25]}},
{"name":"paint","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],"metallicFactor":0.5,"roughnessFactor":0.25}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
{"bufferView":1,"byteOffset":6,"componentType":5123,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":12}],
"buffers":[{)" +
         buffer + R"("byteLength":84}]})";
}

}  // namespace

car::CarModel box_model(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                        const car::Material& material) {
  return car::assemble({material}, box_triangles(low, high));
}

car::CarModel joined(const car::CarModel& a, const car::CarModel& b) {
  std::vector<car::Material> materials;
  std::vector<LooseTriangle> triangles;
  for (const car::CarModel* model : {&a, &b})
    for (const car::Part& part : model->parts) {
      materials.push_back(part.material);
      for (uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3) {
        const auto corner = [&](uint32_t k) { return model->vertices[model->indices[i + k]]; };
        triangles.push_back({{corner(0), corner(1), corner(2)}, static_cast<uint32_t>(materials.size() - 1)});
      }
    }
  return car::assemble(materials, triangles);
}

void write_obj(const std::filesystem::path& path) {
  write_text(path.parent_path() / "small.mtl",
             "newmtl paint\nKd 0.5 0.25 0.125\nNs 1000\nnewmtl window\nKd 0.1 0.1 0.1\n");
  write_text(path,
             "mtllib small.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nusemtl paint\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"
             "usemtl window\nf 2 3 4\n");
}

void write_gltf(const std::filesystem::path& path) {
  if (path.extension() == ".gltf") {
    write_text(path,
               gltf_json("\"uri\":\"data:application/octet-stream;base64," + base64(gltf_buffer()) + "\","));
    return;
  }
  std::string json = gltf_json("");
  while (json.size() % 4 != 0) json += ' ';
  const std::string buffer = gltf_buffer();
  std::string bytes = "glTF";
  append(bytes, uint32_t{2});
  append(bytes, static_cast<uint32_t>(28 + json.size() + buffer.size()));
  append(bytes, static_cast<uint32_t>(json.size()));
  bytes += "JSON" + json;
  append(bytes, static_cast<uint32_t>(buffer.size()));
  bytes += std::string("BIN\0", 4) + buffer;
  write_text(path, bytes);
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace svchain::testing
