#include "algorithms/car/car_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "algorithms/car/blend_row.h"

namespace svchain::car {
namespace {

constexpr double kNearPerLength = 0.01;  // of the near plane's distance

/// The rectangle of pixels around a box, within the picture.
cv::Rect around(const Eigen::AlignedBox2d& box_px, const Eigen::Vector2i& size_px) {
  if (box_px.isEmpty()) return {};
  const Eigen::Vector2d most = size_px.cast<double>();
  const Eigen::Vector2d low = box_px.min().cwiseMax(-2).cwiseMin(most),
                        high = box_px.max().cwiseMax(-2).cwiseMin(most);
  const cv::Point first(cvFloor(low.x()), cvFloor(low.y())), last(cvCeil(high.x()), cvCeil(high.y()));
  return cv::Rect(first, last + cv::Point(1, 1)) & cv::Rect(0, 0, size_px.x(), size_px.y());
}

}  // namespace

CarPicture::CarPicture(CarModel model, const geometry::Vehicle& vehicle, const Light& light)
    : model_(std::move(model)), shadow_(vehicle), box_(bounding_box(model_)) {
  scenery_.light = light;
  scenery_.top = box_.max().z();
  for (uint32_t p = 0; p < model_.parts.size(); ++p) {
    const Part& part = model_.parts[p];
    substances_.emplace_back(part.material);
    for (uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3) {
      const auto corner = [&](uint32_t k) { return model_.vertices[model_.indices[i + k]].position; };
      planes_.push_back({(corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized(), p});
    }
    if (part.material.opaque()) first_translucent_ = static_cast<uint32_t>(planes_.size());
  }
  facets_.resize(planes_.size());
}

/// All of the picture where something is not clearly before the camera.
cv::Rect CarPicture::extent(const Viewpoint& viewpoint, const Rasteriser::Bounds& model) const {
  Eigen::AlignedBox2d box_px = model.box_px;
  bool behind = model.behind;
  const Eigen::Vector2d reach = shadow_.reach().cast<double>();
  if (viewpoint.eye.z() > 0)
    for (const double x : {-reach.x(), reach.x()})
      for (const double y : {-reach.y(), reach.y()}) {
        const Eigen::Vector3d seen = viewpoint.seen({x, y, 0});
        if (seen.z() < kNearPerLength * box_.sizes().x())
          behind = true;
        else
          box_px.extend(viewpoint.pixel(seen));
      }
  if (behind && !box_px.isEmpty()) return {0, 0, viewpoint.size_px.x(), viewpoint.size_px.y()};
  return around(box_px, viewpoint.size_px);
}

void CarPicture::begin(const Viewpoint& viewpoint, float opacity) {
  size_ = {viewpoint.size_px.x(), viewpoint.size_px.y()};
  opacity_ = std::min(opacity, 1.0f);
  const Rasteriser::Bounds& bounds =
      rasteriser_.project(model_, viewpoint, kNearPerLength * box_.sizes().x());
  rectangle_ = opacity > 0 ? extent(viewpoint, bounds) : cv::Rect();
  if (rectangle_.empty()) rectangle_ = {};
  if (rectangle_.width > memory_.cols || rectangle_.height > memory_.rows)
    memory_.create(std::max(rectangle_.height, memory_.rows), std::max(rectangle_.width, memory_.cols),
                   CV_8UC4);
  picture_ = memory_(cv::Rect(cv::Point(), rectangle_.size()));
  rasteriser_.sort(model_, first_translucent_, rectangle_);

  const Eigen::Matrix3d back = viewpoint.camera_from_vehicle.transpose();
  const Eigen::Vector2d first =
      Eigen::Vector2d(rectangle_.x - 0.25, rectangle_.y - 0.25) - viewpoint.centre_px;
  scenery_.rays = {viewpoint.eye.cast<float>(),
                   (back * Eigen::Vector3d(first.x(), first.y(), viewpoint.focal_px)).cast<float>(),
                   (back.col(0) / kSamplesPerSide).cast<float>(),
                   (back.col(1) / kSamplesPerSide).cast<float>()};
  scenery_.facets = facets_.data();
  scenery_.substances = substances_.data();
  for (uint32_t t = 0; t < facets_.size(); ++t) {
    if (!rasteriser_.may_show(t)) continue;
    const auto corner = [&](uint32_t k) { return &model_.vertices[model_.indices[3 * t + k]]; };
    facets_[t] = facet_of({corner(0), corner(1), corner(2)}, scenery_.rays.eye, planes_[t].part);
  }
}

/// Neighbouring bands cost much the same, so that parts take turns.
void CarPicture::draw(int part, int parts) {
  for (int band = part; band < rasteriser_.band_count(); band += parts) draw_band(band, desks_[part]);
}

void CarPicture::draw_band(int band, Desk& desk) {
  rasteriser_.draw(model_, band, desk.samples);
  const int first = band * Rasteriser::kBandRows;
  const int end = std::min(first + Rasteriser::kBandRows, rectangle_.height);
  for (int row = first; row < end; ++row) {
    const float* const light = desk.row.mean_light(desk.samples, kSamplesPerSide * (row - first), row,
                                                   rectangle_.width, scenery_, planes_);
    encode_pixels(scenery_.rays, shadow_, opacity_, row, light, rectangle_.width, desk.row.bytes());
    std::copy_n(desk.row.bytes(), rectangle_.width, picture_.ptr<uint32_t>(row));
  }
}

void CarPicture::render(const Viewpoint& viewpoint, float opacity) {
  begin(viewpoint, opacity);
  draw(0, 1);
}

void CarPicture::blend_over(cv::Mat& bgr) const {
  if (bgr.type() != CV_8UC3 || bgr.size() != size_)
    throw std::invalid_argument("the car was rendered for a BGR picture of " + std::to_string(size_.width) +
                                " x " + std::to_string(size_.height) + " px; this one has " +
                                std::to_string(bgr.cols) + " x " + std::to_string(bgr.rows));
  for (int row = 0; row < rectangle_.height; ++row)
    blend_row(picture_.ptr(row), rectangle_.width, bgr.ptr(rectangle_.y + row) + 3 * rectangle_.x);
}

}  // namespace svchain::car
