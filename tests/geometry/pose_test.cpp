#include <Eigen/LU>
#include <cmath>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/mapped_ground.h"
#include "algorithms/geometry/pose_from_homography.h"
#include "algorithms/geometry/refine_pose.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::geometry;
using Eigen::Vector3d;

namespace {

/// A camera at `position` that looks along `yaw`, turned down by `pitch` and about its axis by `roll`
/// (degrees).
Rigid3 posed(const Vector3d& position, double yaw, double pitch, double roll) {
  Eigen::Matrix3d level;  // looks along x: right is -y, down is -z
  level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(radians(yaw), Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(radians(pitch), Vector3d::UnitY()).toRotationMatrix() *
                                 level * Eigen::AngleAxisd(radians(roll), Vector3d::UnitZ());
  return {Eigen::Quaterniond(turned), position};
}

Eigen::Matrix3d ray_from_ground(const Rigid3& vehicle_from_camera) {
  const Rigid3 camera_from_vehicle = vehicle_from_camera.inverse();
  const Eigen::Matrix3d rotation = camera_from_vehicle.rotation.toRotationMatrix();
  Eigen::Matrix3d h;
  h << rotation.col(0), rotation.col(1), camera_from_vehicle.translation;
  return h;
}

double angle_between(const Rigid3& a, const Rigid3& b) {
  return a.rotation.angularDistance(b.rotation);
}

const std::vector<Rigid3> kPoses = {
    posed({2.4, 0.1, 0.7}, 3, 20, -6), posed({0.8, -1, 1}, -91, 45, 2), posed({-2.3, 0, 0.9}, 177, 35, 1),
    posed({0.8, 1, 1}, 88, 60, 0),     posed({0, 0, 2}, 10, 89, 0),
};

KannalaBrandt fisheye() {
  return {{300, 310}, {480, 320}, {-0.04, 0.01, -0.005, 0.0005}};
}

}  // namespace

TEST_CASE("a pose comes back out of its homography, whatever its factor and sign") {
  for (const auto& pose : kPoses) {
    for (const double factor : {1.0, -1.0, 1e-4, -250.0}) {
      const auto found = pose_from_homography(factor * ray_from_ground(pose));
      REQUIRE(found);
      CHECK((found->translation - pose.translation).norm() < 1e-9);
      CHECK(angle_between(*found, pose) < 1e-7);
    }
  }
}

TEST_CASE("a homography that is off a little gives a pose that is off a little, and a proper rotation") {
  Eigen::Matrix3d h = ray_from_ground(kPoses[0]);
  h(0, 1) += 0.01;
  h(2, 0) -= 0.01;
  const auto found = pose_from_homography(h);
  REQUIRE(found);
  CHECK(found->rotation.norm() == Approx(1).epsilon(1e-12));
  CHECK(angle_between(*found, kPoses[0]) < radians(2));
}

TEST_CASE("a singular homography has no pose") {
  Eigen::Matrix3d h = ray_from_ground(kPoses[0]);
  h.col(2) = 2 * h.col(0);
  CHECK_FALSE(pose_from_homography(h));
  CHECK_FALSE(pose_from_homography(Eigen::Matrix3d::Zero()));
  CHECK_FALSE(pose_from_homography(Eigen::Matrix3d::Constant(std::nan(""))));
}

TEST_CASE("a pose is refined from 10 degrees and 20 cm off to where the points were seen") {
  const auto lens = fisheye();
  for (const auto& pose : kPoses) {
    std::vector<Sighting> sightings;
    for (double x = -6; x <= 6; x += 0.5) {
      for (double y = -6; y <= 6; y += 0.5) {
        const auto pixel = lens.project(pose.inverse() * Vector3d(x, y, 0));
        if (pixel && (*pixel - Eigen::Vector2d(480, 320)).norm() < 400)
          sightings.push_back({{x, y, 0}, *pixel});
      }
    }
    const Rigid3 off{
        Eigen::Quaterniond(Eigen::AngleAxisd(radians(10), Vector3d(1, 2, -1).normalized())) * pose.rotation,
        pose.translation + Vector3d(0.1, -0.1, 0.15)};
    const auto refined = refine_pose(lens, sightings, off);
    CHECK(refined.rms_px < 1e-6);
    CHECK((refined.vehicle_from_camera.translation - pose.translation).norm() < 1e-8);
    CHECK(angle_between(refined.vehicle_from_camera, pose) < 1e-7);
  }
}

TEST_CASE("a camera is posed by how another calibration maps the ground") {
  Eigen::Matrix3d pinhole;
  pinhole << 150, 0, 479.5, 0, 150, 319.5, 0, 0, 1;
  const Eigen::AlignedBox2d ahead(Eigen::Vector2d(2.5, -5), Eigen::Vector2d(8, 5));
  Camera camera{"front", {960, 640}, std::make_shared<KannalaBrandt>(fisheye()), {}};

  SECTION("to where it stands") {
    const MappedGround ground(pinhole * ray_from_ground(kPoses[0]), pinhole, {960, 640}, ahead);
    const auto left_px = pose_camera(ground, "a.yaml", camera);
    REQUIRE(left_px);
    CHECK(*left_px < 1e-6);
    CHECK((camera.vehicle_from_camera.translation - kPoses[0].translation).norm() < 1e-8);
  }
  SECTION("a singular map is refused") {
    const MappedGround ground(Eigen::Matrix3d::Ones(), pinhole, {960, 640}, ahead);
    CHECK(pose_camera(ground, "a.yaml", camera)
              .error()
              .front()
              .text()
              .find("a.yaml: error: the homography is singular") == 0);
  }
  SECTION("a mirrored map is refused") {
    Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
    mirror(1, 1) = -1;
    const MappedGround ground(pinhole * ray_from_ground(kPoses[0]) * mirror, pinhole, {960, 640}, ahead);
    CHECK(pose_camera(ground, "a.yaml", camera).error().front().message.find("mirrored") !=
          std::string::npos);
  }
  SECTION("a map of another camera's side is refused") {
    const Eigen::AlignedBox2d behind(Eigen::Vector2d(-8, -5), Eigen::Vector2d(-2.5, 5));
    const MappedGround ground(pinhole * ray_from_ground(kPoses[2]), pinhole, {960, 640}, behind);
    CHECK(pose_camera(ground, "a.yaml", camera).error().front().message.find("would look inwards") !=
          std::string::npos);
  }
  SECTION("a map that shows no ground is refused") {
    Eigen::Matrix3d aside = Eigen::Matrix3d::Identity();
    aside(0, 2) = 3000;
    const MappedGround ground(aside * pinhole * ray_from_ground(kPoses[0]), pinhole, {960, 640}, ahead);
    CHECK(pose_camera(ground, "a.yaml", camera).error().front().message.find("next to nothing") !=
          std::string::npos);
  }
}
