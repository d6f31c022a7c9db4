#include "algorithms/car/car_picture.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace svchain::car {
namespace {

constexpr double kNearPerLength = 0.01;  // of the near plane's distance
constexpr float kAlikeCosine = 0.94f;    // planes turned by less share their light within a pixel
constexpr float kBrightest = 1.42f;      // is shown as white, and so is all above

/// display() in steps finer than an eighth of a level.
class DisplayTable {
 public:
  DisplayTable() {
    // Steps grow with the root's slope: equal ones of the square root.
    for (size_t i = 0; i < table_.size(); ++i) {
      const float root = static_cast<float>(i) / kLast;
      table_[i] = 255 * display(kBrightest * root * root);
    }
  }
  float operator()(float linear) const {
    const float root = std::sqrt(std::clamp(linear * (1 / kBrightest), 0.0f, 1.0f));
    return table_[static_cast<size_t>(root * kLast + 0.5f)];
  }

 private:
  static constexpr int kLast = 4095;
  std::array<float, kLast + 1> table_;
};

float displayed(float linear) {
  static const DisplayTable table;
  return table(linear);
}

/// Smallest rectangle of pixels around points in the camera's frame, all of the picture where one of them is
/// not clearly before the camera.
class Surroundings {
 public:
  Surroundings(const Viewpoint& viewpoint, double near_m) : viewpoint_(viewpoint), near_m_(near_m) {}

  void add(const Eigen::Vector3d& point) {
    const Eigen::Vector3d seen = viewpoint_.seen(point);
    if (seen.z() < near_m_) {
      behind_ = true;
    } else {
      box_.extend(viewpoint_.pixel(seen));
      before_ = true;
    }
  }
  cv::Rect rectangle() const {
    const cv::Rect whole(0, 0, viewpoint_.size_px.x(), viewpoint_.size_px.y());
    if (!before_) return {};
    if (behind_) return whole;
    const Eigen::Vector2d most = viewpoint_.size_px.cast<double>();
    const Eigen::Vector2d low = box_.min().cwiseMax(-2).cwiseMin(most),
                          high = box_.max().cwiseMax(-2).cwiseMin(most);
    const cv::Point first(cvFloor(low.x()), cvFloor(low.y())), last(cvCeil(high.x()), cvCeil(high.y()));
    return cv::Rect(first, last + cv::Point(1, 1)) & whole;
  }

 private:
  const Viewpoint& viewpoint_;
  double near_m_;
  Eigen::AlignedBox2d box_;
  bool before_ = false, behind_ = false;
};

/// Four premultiplied bytes: the surface over its shadow, times the opacity.
cv::Vec4b encoded(const Lit& surface, float shadow, float opacity) {
  const float alpha = surface.alpha, scale = alpha * opacity;
  if (alpha <= 0) return {0, 0, 0, static_cast<uint8_t>(cvRound(255 * shadow * opacity))};
  const Eigen::Vector3f colour = surface.colour / alpha;
  const auto level = [&](float linear) { return static_cast<uint8_t>(cvRound(displayed(linear) * scale)); };
  const float covered = alpha + (1 - alpha) * shadow;
  return {level(colour.z()), level(colour.y()), level(colour.x()),
          static_cast<uint8_t>(cvRound(255 * std::min(1.0f, covered) * opacity))};
}

}  // namespace

CarPicture::CarPicture(CarModel model, const geometry::Vehicle& vehicle, const Light& light)
    : model_(std::move(model)), shadow_(vehicle), light_(light), box_(bounding_box(model_)) {
  for (uint32_t p = 0; p < model_.parts.size(); ++p) {
    const Part& part = model_.parts[p];
    for (uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3) {
      const auto corner = [&](uint32_t k) { return model_.vertices[model_.indices[i + k]].position; };
      faces_.push_back({(corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized(), p});
    }
    if (part.material.opaque()) first_translucent_ = static_cast<uint32_t>(faces_.size());
  }
}

cv::Rect CarPicture::extent(const Viewpoint& viewpoint) const {
  Surroundings surroundings(viewpoint, kNearPerLength * box_.sizes().x());
  for (const Vertex& vertex : model_.vertices) surroundings.add(vertex.position.cast<double>());
  const Eigen::Vector2d reach = shadow_.reach().cast<double>();
  if (viewpoint.eye.z() > 0)
    for (const double x : {-reach.x(), reach.x()})
      for (const double y : {-reach.y(), reach.y()}) surroundings.add({x, y, 0});
  return surroundings.rectangle();
}

/// Where the ray meets the triangle's plane, by the determinants of the corners as seen from the eye: exact
/// perspective, whatever part of the triangle lies behind the eye.
Lit CarPicture::lit_triangle(uint32_t triangle, const Eigen::Vector3f& ray,
                             const Eigen::Vector3f& eye) const {
  const Face& face = faces_[triangle];
  const uint32_t* const i = &model_.indices[3 * triangle];
  const Vertex &a = model_.vertices[i[0]], &b = model_.vertices[i[1]], &c = model_.vertices[i[2]];
  const Eigen::Vector3f pa = a.position - eye, pb = b.position - eye, pc = c.position - eye;
  Eigen::Vector3f share(ray.dot(pb.cross(pc)), ray.dot(pc.cross(pa)), ray.dot(pa.cross(pb)));
  const float sum = share.sum();
  share = sum == 0 ? Eigen::Vector3f::Constant(1 / 3.0f) : Eigen::Vector3f(share / sum);
  share = share.cwiseMax(0.0f).cwiseMin(1.0f);

  const Eigen::Vector3f to_eye = -ray.normalized();
  Eigen::Vector3f normal = (a.normal * share[0] + b.normal * share[1] + c.normal * share[2]).normalized();
  if (face.normal.dot(to_eye) < 0) normal = -normal;  // a surface has two sides
  const float z = a.position.z() * share[0] + b.position.z() * share[1] + c.position.z() * share[2];
  return lit(light_, model_.parts[face.part].material, normal, to_eye, z / box_.max().z());
}

Lit CarPicture::lit_sample(const Sample& sample, const Eigen::Vector3f& ray,
                           const Eigen::Vector3f& eye) const {
  Lit seen{Eigen::Vector3f::Zero(), 0};
  if (sample.opaque != kNoTriangle) seen = lit_triangle(sample.opaque, ray, eye);
  if (sample.translucent == kNoTriangle) return seen;
  const Lit pane = lit_triangle(sample.translucent, ray, eye);
  return {pane.colour + (1 - pane.alpha) * seen.colour, pane.alpha + (1 - pane.alpha) * seen.alpha};
}

bool CarPicture::alike(uint32_t a, uint32_t b) const {
  if (a == b) return true;
  if (a == kNoTriangle || b == kNoTriangle) return false;
  return faces_[a].part == faces_[b].part && faces_[a].normal.dot(faces_[b].normal) > kAlikeCosine;
}

/// Samples that see much the same are lit once.
Lit CarPicture::lit_pixel(int column, int row, const Rays& rays) const {
  constexpr int kSamples = kSamplesPerSide * kSamplesPerSide;
  std::array<Sample, kSamples> samples;
  for (int k = 0; k < kSamples; ++k)
    samples[k] = rasteriser_.sample(2 * column + k % kSamplesPerSide, 2 * row + k / kSamplesPerSide);

  const auto ray = [&](int k) -> Eigen::Vector3f {
    return rays.first + static_cast<float>(2 * column + k % kSamplesPerSide) * rays.right +
           static_cast<float>(2 * row + k / kSamplesPerSide) * rays.down;
  };

  Lit mean{Eigen::Vector3f::Zero(), 0};
  if (samples[0] == samples[1] && samples[0] == samples[2] && samples[0] == samples[3])
    return samples[0].empty() ? mean : lit_sample(samples[0], ray(0), rays.eye);
  for (int k = 0; k < kSamples; ++k) {
    const Sample first = samples[k];
    if (first.empty()) continue;
    int count = 0;
    for (int m = k; m < kSamples; ++m)
      if (alike(samples[m].opaque, first.opaque) && alike(samples[m].translucent, first.translucent)) {
        samples[m] = {};
        ++count;
      }
    const Lit seen = lit_sample(first, ray(k), rays.eye);
    const float share = static_cast<float>(count) / kSamples;
    mean.colour += share * seen.colour;
    mean.alpha += share * seen.alpha;
  }
  return mean;
}

float CarPicture::shadow(const Eigen::Vector3f& ray, const Eigen::Vector3f& eye) const {
  if (eye.z() <= 0 || ray.z() >= 0) return 0;
  const Eigen::Vector2f ground = eye.head<2>() - (eye.z() / ray.z()) * ray.head<2>();
  return (ground.cwiseAbs() - shadow_.reach()).maxCoeff() > 0 ? 0 : shadow_.shadow_at(ground);
}

void CarPicture::render(const Viewpoint& viewpoint, float opacity) {
  size_ = {viewpoint.size_px.x(), viewpoint.size_px.y()};
  rectangle_ = opacity > 0 ? extent(viewpoint) : cv::Rect();
  if (rectangle_.empty()) rectangle_ = {};
  if (rectangle_.width > memory_.cols || rectangle_.height > memory_.rows)
    memory_.create(std::max(rectangle_.height, memory_.rows), std::max(rectangle_.width, memory_.cols),
                   CV_8UC4);
  picture_ = memory_(cv::Rect(cv::Point(), rectangle_.size()));
  if (rectangle_.empty()) return;
  rasteriser_.draw(model_, first_translucent_, viewpoint, kNearPerLength * box_.sizes().x(), rectangle_);

  const Eigen::Matrix3d back = viewpoint.camera_from_vehicle.transpose();
  const Eigen::Vector2d first =
      Eigen::Vector2d(rectangle_.x - 0.25, rectangle_.y - 0.25) - viewpoint.centre_px;
  const Rays rays = {viewpoint.eye.cast<float>(),
                     (back * Eigen::Vector3d(first.x(), first.y(), viewpoint.focal_px)).cast<float>(),
                     (back.col(0) / kSamplesPerSide).cast<float>(),
                     (back.col(1) / kSamplesPerSide).cast<float>()};
  for (int row = 0; row < rectangle_.height; ++row) {
    cv::Vec4b* const out = picture_.ptr<cv::Vec4b>(row);
    for (int column = 0; column < rectangle_.width; ++column) {
      const Lit surface = lit_pixel(column, row, rays);
      const Eigen::Vector3f ray = rays.first + (2 * static_cast<float>(column) + 0.5f) * rays.right +
                                  (2 * static_cast<float>(row) + 0.5f) * rays.down;
      out[column] = encoded(surface, surface.alpha < 1 ? shadow(ray, rays.eye) : 0, std::min(opacity, 1.0f));
    }
  }
}

void CarPicture::blend_over(cv::Mat& bgr) const {
  if (bgr.type() != CV_8UC3 || bgr.size() != size_)
    throw std::invalid_argument("the car was rendered for a BGR picture of " + std::to_string(size_.width) +
                                " x " + std::to_string(size_.height) + " px; this one has " +
                                std::to_string(bgr.cols) + " x " + std::to_string(bgr.rows));
  for (int row = 0; row < rectangle_.height; ++row) {
    const cv::Vec4b* const car = picture_.ptr<cv::Vec4b>(row);
    cv::Vec3b* const out = bgr.ptr<cv::Vec3b>(rectangle_.y + row) + rectangle_.x;
    for (int column = 0; column < rectangle_.width; ++column) {
      const uint32_t rest = 255u - car[column][3];
      for (int c = 0; c < 3; ++c) {
        const uint32_t kept = out[column][c] * rest + 128;  // over 255, rounded
        out[column][c] = static_cast<uint8_t>(car[column][c] + ((kept + (kept >> 8)) >> 8));
      }
    }
  }
}

}  // namespace svchain::car
