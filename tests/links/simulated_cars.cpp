#include "tests/links/simulated_cars.h"

#include <cmath>
#include <stdexcept>

#include "algorithms/scene/renderer.h"
#include "algorithms/scene/scene_file.h"
#include "links/capture/simulated_source.h"
#include "links/geometric_alignment/geometric_alignment.h"
#include "tests/synthesis/decoded_lut.h"

namespace svchain::testing {

namespace {

const Eigen::Vector2i kViewSize(440, 540);

/// Where the ground is that a camera shows at a pixel.
Eigen::Vector2d ground_at(const geometry::Camera& camera, const DecodedTap& tap) {
  const auto ray = camera.lens->unproject({tap.px(), tap.py()});
  if (!ray) throw std::runtime_error("a LUT samples " + camera.name + " beyond its lens");
  const Eigen::Vector3d line = camera.vehicle_from_camera.rotation * *ray;
  const Eigen::Vector3d& from = camera.vehicle_from_camera.translation;
  return (from - line * (from.z() / line.z())).head<2>();
}

}  // namespace

SimulatedCar::SimulatedCar(const std::string& name) : input("simulated:" + name) {
  scene = scene::read_scene(find_scene(name).value()).value();
  const scene::Renderer renderer(std::make_shared<const scene::World>(scene));
  for (size_t i = 0; i < 4; ++i) renderer.render(i, 0, 0, pictures[i]);
}

const SimulatedCar& parking_car() {
  static const SimulatedCar car("parking");
  return car;
}

const SimulatedCar& toy_car() {
  static const SimulatedCar car("toy");
  return car;
}

AlignmentAlone::AlignmentAlone(const SimulatedCar& car, const std::string& source, Rig rig)
    : LinkHarness(make_geometric_alignment()), car_(car) {
  if (rig == Rig::kUnwanted) disconnect("rig");
  parameter("source", source);
  setting("input", car.input);
  setting("rig", nullptr);
  setting("view", "size_px", {kViewSize.x(), kViewSize.y()});
  setting("view", "metres_per_px", nullptr);
  setting("view", "centre_m", {0, 0});
  PortFormat frames;
  for (const auto& camera : car.scene.rig.cameras)
    frames.push_back(Format::bgr8(camera.image_size_px.x(), camera.image_size_px.y()));
  input("frames", frames);
}

void AlignmentAlone::push_pictures() {
  push_set(car_.pictures);
}

void AlignmentAlone::push_black() {
  std::array<cv::Mat, 4> black;
  for (size_t i = 0; i < 4; ++i) black[i] = cv::Mat::zeros(car_.pictures[i].size(), CV_8UC3);
  push_set(black);
}

void AlignmentAlone::push_set(const std::array<cv::Mat, 4>& pictures) {
  push("frames", {.sequence = pushed_++, .write = [&](int camera, std::span<std::byte> bytes) {
                    const cv::Mat& picture = pictures[static_cast<size_t>(camera)];
                    const Format format = Format::bgr8(picture.cols, picture.rows);
                    picture.copyTo(cv::Mat(picture.size(), CV_8UC3, bytes.data(),
                                           static_cast<size_t>(format.pitch_bytes)));
                  }});
  run();
}

geometry::View AlignmentAlone::view() const {
  return {kViewSize, geometry::default_metres_per_px(car_.scene.rig.vehicle, kViewSize), {0, 0}};
}

LutErrors errors_of(std::span<const std::byte> lut, const geometry::Rig& truth, const geometry::View& view) {
  const DecodedLut decoded = decode(synthesis::GeometricLut(lut));
  double places = 0, blends = 0;
  size_t place_count = 0, blend_count = 0;
  for (int row = 0; row < decoded.height; ++row)
    for (int column = 0; column < decoded.width; ++column) {
      const DecodedPixel& pixel = decoded.at(column, row);
      std::array<Eigen::Vector2d, 2> shown;
      for (int i = 0; i < pixel.tap_count(); ++i, ++place_count) {
        shown[i] = ground_at(truth.cameras[pixel.taps[i].camera], pixel.taps[i]);
        places += (shown[i] - view.ground_from_pixel({column, row})).squaredNorm();
      }
      if (pixel.tap_count() < 2) continue;
      blends += (shown[0] - shown[1]).squaredNorm();
      ++blend_count;
    }
  return {std::sqrt(places / place_count), std::sqrt(blends / blend_count)};
}

}  // namespace svchain::testing
