#include "algorithms/scene/shapes.h"

#include <numbers>

namespace svchain::scene {

Outline rectangle(const Pose2& pose, double length_m, double width_m) {
  const double l = length_m / 2;
  const double w = width_m / 2;
  return {pose * Eigen::Vector2d(-l, -w), pose * Eigen::Vector2d(l, -w), pose * Eigen::Vector2d(l, w),
          pose * Eigen::Vector2d(-l, w)};
}

Outline disc(const Pose2& pose, double radius_m) {
  constexpr int kCorners = 40;
  Outline outline;
  for (int i = 0; i < kCorners; ++i) {
    const double a = 2 * std::numbers::pi * i / kCorners;
    outline.push_back(pose * Eigen::Vector2d(radius_m * std::cos(a), radius_m * std::sin(a)));
  }
  return outline;
}

Outlines line(const Outline& points_m, double width_m) {
  Outlines outlines;
  for (size_t i = 1; i < points_m.size(); ++i) {
    const Eigen::Vector2d along = points_m[i] - points_m[i - 1];
    const Eigen::Vector2d middle = (points_m[i] + points_m[i - 1]) / 2;
    const Pose2 pose{middle.x(), middle.y(), std::atan2(along.y(), along.x())};
    outlines.push_back(rectangle(pose, along.norm() + width_m, width_m));
  }
  return outlines;
}

Outlines arrow(const Pose2& pose, double length_m, double width_m) {
  const double neck = length_m * 0.1;  // where the head begins
  const double tip = length_m / 2;
  const auto at = [&](double x, double y) { return pose * Eigen::Vector2d(x, y); };
  const Eigen::Vector2d middle = at((neck - tip) / 2, 0);
  return {rectangle({middle.x(), middle.y(), pose.yaw_rad}, neck + tip, width_m * 0.28),
          {at(neck, -width_m / 2), at(tip, 0), at(neck, width_m / 2)}};
}

Outlines zebra(const Pose2& pose, double length_m, double width_m, int bars) {
  Outlines outlines;
  const double bar = width_m / (2 * bars - 1);
  for (int i = 0; i < bars; ++i) {
    const Eigen::Vector2d middle = pose * Eigen::Vector2d(0, (2 * i + 0.5) * bar - width_m / 2);
    outlines.push_back(rectangle({middle.x(), middle.y(), pose.yaw_rad}, length_m, bar));
  }
  return outlines;
}

Outlines bays(const Pose2& pose, int count, double length_m, double depth_m, double line_m) {
  Outlines outlines;
  const auto at = [&](double x, double y) { return pose * Eigen::Vector2d(x, y); };
  for (int i = 0; i <= count; ++i) {
    const auto side = line({at(i * length_m, 0), at(i * length_m, depth_m)}, line_m);
    outlines.insert(outlines.end(), side.begin(), side.end());
  }
  const auto back = line({at(0, depth_m), at(count * length_m, depth_m)}, line_m);
  outlines.insert(outlines.end(), back.begin(), back.end());
  return outlines;
}

std::vector<Patch> patches(const Checkerboard& board) {
  constexpr Colour kWhite{232, 232, 232};
  constexpr Colour kBlack{24, 24, 24};
  const double side = board.square_m;
  std::vector<Patch> list = {
      {rectangle(board.world_from_chart, (board.squares[0] + 1) * side, (board.squares[1] + 1) * side),
       kWhite, 1}};
  for (int j = 0; j < board.squares[1]; ++j) {
    for (int i = j % 2; i < board.squares[0]; i += 2) {
      list.push_back(
          {{board.corner(i, j), board.corner(i + 1, j), board.corner(i + 1, j + 1), board.corner(i, j + 1)},
           kBlack,
           1});
    }
  }
  return list;
}

}  // namespace svchain::scene
