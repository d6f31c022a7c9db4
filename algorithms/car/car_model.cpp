#include "algorithms/car/car_model.h"

#include <cmath>

namespace svchain::car {
namespace {

constexpr float kWidthTolerance = 0.15f;

}  // namespace

Eigen::AlignedBox3f bounding_box(const CarModel& model) {
  Eigen::AlignedBox3f box;
  for (const Vertex& vertex : model.vertices) box.extend(vertex.position);
  return box;
}

Eigen::AlignedBox3f bounding_box(const CarModel& model, const Part& part) {
  Eigen::AlignedBox3f box;
  for (uint32_t i = 0; i < part.index_count; ++i)
    box.extend(model.vertices[model.indices[part.first_index + i]].position);
  return box;
}

CarModel fit_to(const CarModel& model, const geometry::Vehicle& vehicle) {
  const Eigen::AlignedBox3f box = bounding_box(model);
  const Eigen::Vector3f size = box.sizes();
  const auto length_m = static_cast<float>(vehicle.length_m), width_m = static_cast<float>(vehicle.width_m);
  Eigen::Vector3f scale = Eigen::Vector3f::Constant(length_m / size.x());
  if (std::abs(size.y() * scale.y() / width_m - 1) > kWidthTolerance) scale.y() = width_m / size.y();

  const Eigen::Vector3f foot(box.center().x(), box.center().y(), box.min().z());
  CarModel fitted = model;
  for (Vertex& vertex : fitted.vertices) {
    vertex.position = (vertex.position - foot).cwiseProduct(scale);
    vertex.normal = vertex.normal.cwiseQuotient(scale).normalized();
  }
  return fitted;
}

}  // namespace svchain::car
