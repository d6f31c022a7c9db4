#include "algorithms/car/model_file.h"

#include <algorithm>
#include <exception>
#include <fstream>

#include "algorithms/car/loose_model.h"

namespace svchain::car {
namespace {

constexpr float kCreaseDeg = 40;

Eigen::Vector3f direction(Axis axis) {
  const int a = static_cast<int>(axis);
  return Eigen::Vector3f::Unit(a / 2) * (a % 2 == 0 ? 1.0f : -1.0f);
}

/// Rows: where the vehicle's x, y and z are in the file.
Eigen::Matrix3f vehicle_from_file(const Orientation& orientation) {
  const Eigen::Vector3f forward = direction(orientation.forward), up = direction(orientation.up);
  Eigen::Matrix3f rotation;
  rotation << forward.transpose(), up.cross(forward).transpose(), up.transpose();
  return rotation;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

LooseModel read_loose(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  if (extension == ".obj") return read_obj(path);
  if (extension == ".gltf" || extension == ".glb") return read_gltf(path);
  throw ModelError{"expected a car model: .obj, .gltf or .glb"};
}

bool has_normals(const LooseTriangle& triangle) {
  return std::ranges::all_of(triangle.corners, [](const Vertex& v) { return v.normal.squaredNorm() > 0; });
}

/// Normals where there are none; those that there are become unit vectors.
void complete_normals(std::vector<LooseTriangle>& triangles) {
  const auto bare = std::stable_partition(triangles.begin(), triangles.end(), has_normals);
  for (auto t = triangles.begin(); t != bare; ++t)
    for (Vertex& corner : t->corners) corner.normal.stableNormalize();
  smooth_normals(std::span(bare, triangles.end()), kCreaseDeg);
}

CarModel turned_model(LooseModel loose, const Orientation& orientation) {
  const Eigen::Matrix3f rotation = vehicle_from_file(orientation);
  for (LooseTriangle& triangle : loose.triangles)
    for (Vertex& corner : triangle.corners) corner = {rotation * corner.position, rotation * corner.normal};
  complete_normals(loose.triangles);
  CarModel model = assemble(loose.materials, loose.triangles);
  const Eigen::Vector3f size = bounding_box(model).sizes();
  if (model.indices.empty()) throw ModelError{"has no triangles; expected the surface of a car"};
  if (!(size.x() > 0 && size.y() > 0)) throw ModelError{"is flat; expected a car with a length and a width"};
  return model;
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path, uintmax_t room) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw ModelError{path.filename().string() + " does not exist"};
  if (!std::filesystem::is_regular_file(path, error))
    throw ModelError{path.filename().string() + " is not a file"};
  const uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > room)
    throw ModelError{path.filename().string() + " makes the model larger than " +
                     std::to_string(kLargestFile >> 20) + " MB; expected a car"};
  std::string bytes(size, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw ModelError{path.filename().string() + " cannot be read"};
  return bytes;
}

void check_count(size_t triangles) {
  if (triangles > kMostTriangles)
    throw ModelError{"has more than " + std::to_string(kMostTriangles) + " triangles; expected a car"};
}

void check_finite(const Eigen::Vector3f& position) {
  // Squares of what is larger would overflow.
  if (!position.allFinite() || position.cwiseAbs().maxCoeff() > 1e6f)
    throw ModelError{"has a corner that is nowhere; expected coordinates of at most 1000000"};
}

bool names_glass(const std::string& name) {
  const std::string text = lower(name);
  return text.find("glass") != std::string::npos || text.find("window") != std::string::npos;
}

Result<CarModel> read_car_model(const std::filesystem::path& path, const Orientation& orientation) {
  try {
    return turned_model(read_loose(path), orientation);
  } catch (const ModelError& error) {
    return fail(path.string(), error.message);
  } catch (const std::exception& error) {
    return fail(path.string(), std::string("is not a model that can be read: ") + error.what());
  }
}

}  // namespace svchain::car
