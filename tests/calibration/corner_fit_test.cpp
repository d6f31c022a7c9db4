#include "algorithms/calibration/corner_fit.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <random>

#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/scene/scene_file.h"
#include "algorithms/scene/shapes.h"
#include "algorithms/scene/still_renderer.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::calibration;
using Eigen::Vector2d;

namespace {

struct PlacedCorner {
  geometry::Pose2 vehicle_from_corner;
  DarkQuarters dark;
  double reach_m;
};

/// What four cameras see of corners whose places are known.
struct Pictures {
  scene::Scene scene;
  std::vector<PlacedCorner> corners;
  std::vector<cv::Mat> grey;  // CV_32F, without noise
};

void add_corners(const Chart& chart, const geometry::Pose2& pose, std::vector<PlacedCorner>& placed) {
  for (const auto& corner : corners(chart)) {
    const Vector2d place = pose * corner.place_m;
    placed.push_back({{place.x(), place.y(), pose.yaw_rad}, corner.dark, corner.reach_m});
  }
}

void take(Pictures& pictures) {
  for (auto& response : pictures.scene.responses) response.noise_sigma = 0;
  const scene::StillRenderer renderer(std::make_shared<const scene::World>(pictures.scene));
  for (size_t camera = 0; camera < 4; ++camera) {
    cv::Mat grey;
    cv::cvtColor(renderer.render(camera, 0, 0), grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(grey, CV_32F);
    pictures.grey.push_back(grey);
  }
}

scene::Scene parking() {
  return *scene::read_scene(testing::project_folder() / "configs/scenes/parking.json");
}

/// The checkerboards of the parking lot: saddles.
const Pictures& boards() {
  static const Pictures kBoards = [] {
    Pictures pictures{parking(), {}, {}};
    for (const auto& board : pictures.scene.charts) {
      Chart chart;
      chart.squares = board.squares;
      chart.side_m = board.square_m;
      add_corners(chart, board.world_from_chart, pictures.corners);
    }
    take(pictures);
    return pictures;
  }();
  return kBoards;
}

/// Single black squares on white, turned each way, in the same places: bends.
const Pictures& squares() {
  static const Pictures kSquares = [] {
    Pictures pictures{parking(), {}, {}};
    pictures.scene.charts.clear();
    pictures.scene.paint.clear();
    Chart chart;
    chart.type = ChartType::kSquares;
    chart.side_m = 0.3;
    chart.centres_m = {{0, 0}};
    for (int k = 0; k < 36; ++k) {
      const geometry::Pose2 pose{(k < 18 ? 1 : -1) * (2.8 + 0.65 * (k % 3)),
                                 (k / 3 % 2 ? -1 : 1) * (1.4 + 0.65 * (k / 6 % 3)), 0.03 * k};
      pictures.scene.paint.push_back({scene::rectangle(pose, 0.6, 0.6), {225, 225, 225}, 1});
      pictures.scene.paint.push_back({scene::rectangle(pose, 0.3, 0.3), {25, 25, 25}, 1});
      add_corners(chart, pose, pictures.corners);
    }
    for (auto& corner : pictures.corners) corner.reach_m = 0.15;  // as far as the white around goes
    take(pictures);
    return pictures;
  }();
  return kSquares;
}

/// What becomes of the light before it is a picture of bytes.
struct Exposure {
  double noise = 2;
  double blur_px = 0;
  double gain = 1;
};

cv::Mat exposed(const cv::Mat& light, const Exposure& exposure) {
  cv::Mat grey = light * exposure.gain;
  if (exposure.blur_px > 0) cv::GaussianBlur(grey, grey, {0, 0}, exposure.blur_px);
  cv::Mat noise(grey.size(), CV_32F);
  cv::RNG rng(7);
  rng.fill(noise, cv::RNG::NORMAL, 0, exposure.noise);
  grey += noise;
  grey.convertTo(grey, CV_8U);
  return grey;
}

std::optional<CornerGuess> true_guess(const geometry::Camera& camera, const PlacedCorner& corner) {
  const auto see = [&](const Vector2d& off_m) {
    const Vector2d place = corner.vehicle_from_corner * off_m;
    return camera.see({place.x(), place.y(), 0});
  };
  constexpr double kStepM = 1e-3;
  const auto pixel = see({0, 0}), x = see({kStepM, 0}), y = see({0, kStepM});
  if (!pixel || !x || !y) return std::nullopt;
  const CornerGuess guess{*pixel, (*x - *pixel) / kStepM * corner.reach_m,
                          (*y - *pixel) / kStepM * corner.reach_m, corner.dark};
  constexpr double kLeastEdgePx = 5;
  if (std::min(guess.along_x_px.norm(), guess.along_y_px.norm()) < kLeastEdgePx) return std::nullopt;
  return guess;
}

using Visit = std::function<void(const cv::Mat&, const geometry::Lens&, const CornerGuess&)>;

/// Every corner that a camera sees with edges of 5 px or more.
void for_all_corners(const Pictures& pictures, const Exposure& exposure, const Visit& visit) {
  for (size_t i = 0; i < 4; ++i) {
    const auto& camera = pictures.scene.rig.cameras[i];
    const cv::Mat grey = exposed(pictures.grey[i], exposure);
    for (const auto& corner : pictures.corners) {
      if (const auto guess = true_guess(camera, corner)) visit(grey, *camera.lens, *guess);
    }
  }
}

/// Off by up to 0.4 half windows, 15 degrees and a quarter of the length.
CornerGuess spoilt(const CornerGuess& guess, std::mt19937& rng) {
  std::uniform_real_distribution<double> chance(-1, 1);
  const auto edge = [&](const Vector2d& v) -> Vector2d {
    return Eigen::Rotation2Dd(chance(rng) * std::numbers::pi / 12) * v * (1 + 0.25 * chance(rng));
  };
  const double shorter_px = std::min(guess.along_x_px.norm(), guess.along_y_px.norm());
  const double half_px = std::min(12.0, 0.45 * shorter_px);
  const Vector2d off = Eigen::Rotation2Dd(chance(rng) * std::numbers::pi) * Vector2d(0.4 * half_px, 0);
  return {guess.pixel + std::abs(chance(rng)) * off, edge(guess.along_x_px), edge(guess.along_y_px),
          guess.dark};
}

struct Score {
  int tried = 0;
  int found = 0;
  double squares_px2 = 0;  // per axis
  double normalised = 0;   // the same, in units of the covariance

  double rms_px() const { return std::sqrt(squares_px2 / found); }
  double rms_in_sigmas() const { return std::sqrt(normalised / found); }
};

Score score(const Pictures& pictures, const Exposure& exposure) {
  Score sum;
  std::mt19937 rng(5);
  for_all_corners(pictures, exposure,
                  [&](const cv::Mat& grey, const geometry::Lens& lens, const auto& guess) {
                    ++sum.tried;
                    const auto corner = fit_corner(grey, lens, spoilt(guess, rng));
                    if (!corner) return;
                    ++sum.found;
                    const Vector2d error = corner->pixel - guess.pixel;
                    sum.squares_px2 += error.squaredNorm() / 2;
                    sum.normalised += error.dot(corner->covariance_px2.inverse() * error) / 2;
                  });
  return sum;
}

}  // namespace

TEST_CASE("saddles are found to a fiftieth of a pixel from guesses that are far off, and know how well") {
  const Score sum = score(boards(), {});
  CHECK(sum.tried > 90);
  CHECK(sum.found > 0.97 * sum.tried);
  CHECK(sum.rms_px() < 0.02);
  CHECK(sum.rms_in_sigmas() > 0.6);
  CHECK(sum.rms_in_sigmas() < 1.6);
}

TEST_CASE("bends are found to a tenth of a pixel from guesses that are far off, and know how well") {
  const Score sum = score(squares(), {});
  CHECK(sum.tried > 200);
  CHECK(sum.found > 0.9 * sum.tried);
  CHECK(sum.rms_px() < 0.1);
  CHECK(sum.rms_in_sigmas() > 0.6);
  CHECK(sum.rms_in_sigmas() < 1.6);
}

TEST_CASE("saddles are found in pictures that are blurred, dim or have their white clipped") {
  for (const Exposure& exposure : {Exposure{2, 1.4, 1}, Exposure{2, 0, 0.2}, Exposure{2, 0, 1.3}}) {
    const Score sum = score(boards(), exposure);
    CAPTURE(exposure.blur_px, exposure.gain);
    CHECK(sum.found > 0.97 * sum.tried);
    CHECK(sum.rms_px() < 0.05);
    CHECK(sum.rms_in_sigmas() > 0.6);
    CHECK(sum.rms_in_sigmas() < 1.6);
  }
}

TEST_CASE("a picture of floats gives the same corners as one of bytes") {
  int found = 0;
  for_all_corners(boards(), {}, [&](const cv::Mat& grey, const geometry::Lens& lens, const auto& guess) {
    cv::Mat floats;
    grey.convertTo(floats, CV_32F);
    const auto of_bytes = fit_corner(grey, lens, guess), of_floats = fit_corner(floats, lens, guess);
    REQUIRE(of_bytes.has_value() == of_floats.has_value());
    if (!of_bytes) return;
    ++found;
    CHECK(of_bytes->pixel == of_floats->pixel);
  });
  CHECK(found > 90);
}

TEST_CASE("a corner that is light for dark is refused, one of another kind but once in five hundred times") {
  int tried = 0, taken = 0;
  for (const Pictures* pictures : {&boards(), &squares()}) {
    for_all_corners(*pictures, {}, [&](const cv::Mat& grey, const geometry::Lens& lens, CornerGuess guess) {
      const auto right = guess.dark;
      guess.dark = static_cast<DarkQuarters>(0b1111 & ~right);
      CHECK_FALSE(fit_corner(grey, lens, guess));
      for (const DarkQuarters wrong : {0b0001, 0b0010, 0b0100, 0b1000, 0b0101, 0b1010, 0b1110, 0b1101}) {
        guess.dark = wrong;
        if (wrong == right) continue;
        ++tried;
        taken += fit_corner(grey, lens, guess).has_value();
      }
    });
  }
  CHECK(tried > 2000);
  CHECK(taken <= tried / 500);
}

TEST_CASE("where no corner is, on asphalt or on the middle of an edge or of a square, none is found") {
  int refused = 0;
  for_all_corners(boards(), {}, [&](const cv::Mat& grey, const geometry::Lens& lens, CornerGuess guess) {
    const Vector2d corner = guess.pixel;
    for (const Vector2d& off : {Vector2d(0.5, 0), Vector2d(0, 0.5), Vector2d(0.5, 0.5), Vector2d(20, 0)}) {
      guess.pixel = corner + off.x() * guess.along_x_px + off.y() * guess.along_y_px;
      if (!(guess.pixel.x() > 200 && guess.pixel.x() < 1080)) continue;
      CHECK_FALSE(fit_corner(grey, lens, guess));
      ++refused;
    }
  });
  CHECK(refused > 150);
}

TEST_CASE("two dark quarters side by side are no corner") {
  const auto& camera = boards().scene.rig.cameras[0];
  const cv::Mat grey = exposed(boards().grey[0], {});
  CHECK_FALSE(fit_corner(grey, *camera.lens, {{400, 400}, {20, 0}, {0, 20}, 0b0011}));
}

TEST_CASE("too near to where the picture or the lens ends there is no corner") {
  const geometry::KannalaBrandt lens({100, 100}, {99.5, 99.5}, {0, 0, 0, 0}, 0.9);
  cv::Mat grey(200, 200, CV_8U);
  const auto draw = [&](const cv::Point& corner) {
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) grey.at<uint8_t>(y, x) = (x < corner.x) == (y < corner.y) ? 20 : 220;
    }
    cv::GaussianBlur(grey, grey, {0, 0}, 0.7);
    return fit_corner(grey, lens,
                      {Vector2d(corner.x - 0.5, corner.y - 0.5), {30, 0}, {0, 30}, DarkQuarters(0b0101)});
  };
  REQUIRE(draw({100, 100}));
  CHECK(draw({130, 100}));
  CHECK_FALSE(draw({185, 100}));  // the lens ends at 189
  CHECK_FALSE(fit_corner(grey(cv::Rect(0, 0, 190, 105)), lens, {{99.5, 99.5}, {30, 0}, {0, 30}, 0b0101}));
}
