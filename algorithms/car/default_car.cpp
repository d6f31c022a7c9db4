#include "algorithms/car/default_car.h"

#include "algorithms/car/body_shape.h"
#include "algorithms/car/default_car_parts.h"

namespace svchain::car {

const std::vector<Material>& substances() {
  static const std::vector<Material> all = {
      {"paint", {0.030f, 0.095f, 0.235f}, 1, 0.92f, 0.45f},
      {"trim", {0.016f, 0.016f, 0.017f}, 1, 0.40f, 0},
      {"underbody", {0.006f, 0.006f, 0.006f}, 1, 0, 0},
      {"interior", {0.022f, 0.021f, 0.021f}, 1, 0.1f, 0},
      {"tyre", {0.016f, 0.016f, 0.017f}, 1, 0.2f, 0},
      {"rim", {0.62f, 0.63f, 0.65f}, 1, 0.7f, 0.75f},
      {"disc", {0.16f, 0.16f, 0.17f}, 1, 0.5f, 0.6f},
      {"light_front", {0.90f, 0.92f, 0.95f}, 1, 0.95f, 0},
      {"light_rear", {0.48f, 0.010f, 0.012f}, 1, 0.9f, 0},
      {"chrome", {0.75f, 0.76f, 0.78f}, 1, 0.95f, 0.9f},
      {"plate", {0.70f, 0.70f, 0.68f}, 1, 0.3f, 0},
      {"glass", {0.006f, 0.008f, 0.010f}, 0.62f, 1, 0},
  };
  return all;
}

CarModel default_car(const geometry::Vehicle& vehicle) {
  SurfaceCollector surfaces;
  add_body(surfaces);
  add_cabin(surfaces);
  add_wheels(surfaces, kFrontAxle);
  add_wheels(surfaces, kRearAxle);
  CarModel model = assemble(substances(), surfaces.triangles());

  const auto along = static_cast<float>(vehicle.length_m) / kLength;
  const Eigen::Vector3f scale(along, static_cast<float>(vehicle.width_m) / kWidth, along);
  for (Vertex& vertex : model.vertices) {
    vertex.position = vertex.position.cwiseProduct(scale);
    vertex.normal = vertex.normal.cwiseQuotient(scale).normalized();
  }
  return model;
}

}  // namespace svchain::car
