#include "algorithms/car/rasteriser.h"

#include <algorithm>
#include <array>

namespace svchain::car {
namespace {

constexpr float kOverlap = 0.002f;  // samples that neighbours share along their edge

int whole_above(float v) {  // of a number >= 0
  const int whole = static_cast<int>(v);
  return whole + (static_cast<float>(whole) < v);
}

/// First and last whole number within [low, high] and first..last, which are not negative.
struct Range {
  int first, last;
  Range(float low, float high, int least, int most)
      : first(whole_above(std::clamp(low, static_cast<float>(least), static_cast<float>(most + 1)))),
        last(high < 0 ? -1 : static_cast<int>(std::min(high, static_cast<float>(most)))) {}
};

/// A corner's share over the picture: 0 on the edge p q against it, 1 in the corner. Places count from
/// (x0, y0).
struct Share {
  float along_x, along_y, at_first;

  template <class Point>
  Share(const Point& p, const Point& q, double inverse_area, float x0, float y0) {
    const double dx = (static_cast<double>(p.y) - q.y) * inverse_area;
    const double dy = (static_cast<double>(q.x) - p.x) * inverse_area;
    along_x = static_cast<float>(dx);
    along_y = static_cast<float>(dy);
    at_first =
        static_cast<float>(dx * (static_cast<double>(x0) - p.x) + dy * (static_cast<double>(y0) - p.y));
  }
};

/// What of each row lies between a triangle's edges: right of up to two of them and left of as many.
class RowsBetween {
 public:
  RowsBetween(const std::array<Share, 3>& shares, float width) : width_(width) {
    high_.fill({width, 0});
    int lows = 0, highs = 0;
    for (const Share& share : shares) {
      if (share.along_x == 0) continue;  // a horizontal edge: the rows end there
      const float inverse = 1 / share.along_x;
      const Line crossing = {-share.at_first * inverse, -share.along_y * inverse};
      if (share.along_x > 0)
        low_[lows++ & 1] = {crossing.at_first - kOverlap, crossing.along_y};
      else
        high_[highs++ & 1] = {crossing.at_first + kOverlap, crossing.along_y};
    }
    if (lows == 1) low_[1] = low_[0];
    if (highs == 1) high_[1] = high_[0];
  }
  float low(float down) const { return std::max({0.0f, low_[0].at(down), low_[1].at(down)}); }
  float high(float down) const { return std::min({width_, high_[0].at(down), high_[1].at(down)}); }

 private:
  struct Line {
    float at_first = 0, along_y = 0;
    float at(float down) const { return at_first + down * along_y; }
  };
  std::array<Line, 2> low_, high_;
  float width_;
};

}  // namespace

/// Where triangles are drawn: samples of the picture, and what of them belongs to the band.
struct Rasteriser::Target {
  cv::Rect samples;
  float* inverse;
  uint32_t* triangle;

  void draw(uint32_t t, const Point& a, const Point& b, const Point& c) const;
};

void SampleBand::clear(int columns, int rows) {
  columns_ = columns;
  const auto count = static_cast<size_t>(columns) * rows;
  inverse_.assign(count, 0);
  opaque_.assign(count, kNoTriangle);
  translucent_.assign(count, kNoTriangle);
}

Rasteriser::Point Rasteriser::projected(const Eigen::Vector3f& seen) const {
  const float inverse = 1 / seen.z();
  return {centre_.x() + focal_ * seen.x() * inverse, centre_.y() + focal_ * seen.y() * inverse, inverse};
}

const Rasteriser::Bounds& Rasteriser::project(const CarModel& model, const Viewpoint& viewpoint,
                                              double near_m) {
  near_ = static_cast<float>(near_m);
  focal_ = static_cast<float>(viewpoint.focal_px * kSamplesPerSide);
  centre_ = ((viewpoint.centre_px.array() + 0.25) * kSamplesPerSide).matrix().cast<float>();
  const Eigen::Matrix3f rotation = viewpoint.camera_from_vehicle.cast<float>();
  const Eigen::Vector3f eye = viewpoint.eye.cast<float>();
  seen_.resize(model.vertices.size());
  points_.resize(model.vertices.size());
  Eigen::AlignedBox2f box;
  bounds_.behind = false;
  for (size_t i = 0; i < model.vertices.size(); ++i) {
    seen_[i] = rotation * (model.vertices[i].position - eye);
    if (seen_[i].z() >= near_) {
      points_[i] = projected(seen_[i]);
      box.extend(Eigen::Vector2f(points_[i].x, points_[i].y));
    } else {
      bounds_.behind = true;
    }
  }
  bounds_.box_px.setEmpty();
  if (!box.isEmpty())
    bounds_.box_px = {box.min().cast<double>() / kSamplesPerSide - Eigen::Vector2d(0.25, 0.25),
                      box.max().cast<double>() / kSamplesPerSide - Eigen::Vector2d(0.25, 0.25)};
  return bounds_;
}

/// None where no sample can be inside.
Rasteriser::Bands Rasteriser::bands_of(const uint32_t* corners) const {
  const uint32_t i = corners[0], j = corners[1], k = corners[2];
  const int before = (seen_[i].z() >= near_) + (seen_[j].z() >= near_) + (seen_[k].z() >= near_);
  if (before == 0) return {};
  if (before < 3) return {0, static_cast<int16_t>(band_count() - 1)};
  const Point &a = points_[i], &b = points_[j], &c = points_[k];
  const Range columns(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), samples_.x, samples_.br().x - 1);
  const Range rows(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), samples_.y, samples_.br().y - 1);
  if (columns.first > columns.last || rows.first > rows.last) return {};
  constexpr int kRows = kBandRows * kSamplesPerSide;
  return {static_cast<int16_t>((rows.first - samples_.y) / kRows),
          static_cast<int16_t>((rows.last - samples_.y) / kRows)};
}

void Rasteriser::sort(const CarModel& model, uint32_t first_translucent, const cv::Rect& rectangle) {
  first_translucent_ = first_translucent;
  samples_ = {rectangle.tl() * kSamplesPerSide, rectangle.size() * kSamplesPerSide};
  starts_.assign((rectangle.height + kBandRows - 1) / kBandRows + 1, 0);
  bands_.resize(model.triangle_count());
  for (size_t t = 0; t < bands_.size(); ++t) {
    bands_[t] = bands_of(&model.indices[3 * t]);
    for (int band = bands_[t].first; band <= bands_[t].last; ++band) ++starts_[band + 1];
  }
  for (size_t band = 1; band < starts_.size(); ++band) starts_[band] += starts_[band - 1];
  sorted_.resize(starts_.back());
  // From the last to the first, so that ends become starts.
  for (size_t band = 0; band + 1 < starts_.size(); ++band) starts_[band] = starts_[band + 1];
  for (size_t t = bands_.size(); t-- > 0;)
    for (int band = bands_[t].first; band <= bands_[t].last; ++band)
      sorted_[--starts_[band]] = static_cast<uint32_t>(t);
}

void Rasteriser::draw(const CarModel& model, int band, SampleBand& samples) const {
  constexpr int kRows = kBandRows * kSamplesPerSide;
  const cv::Rect whole(samples_.x, samples_.y + band * kRows, samples_.width, kRows);
  Target target = {whole & samples_, nullptr, nullptr};
  samples.clear(target.samples.width, target.samples.height);
  target.inverse = samples.inverse_.data();
  for (const uint32_t t : triangles(band)) {
    // What is translucent comes last, so that one depth serves both.
    target.triangle = t < first_translucent_ ? samples.opaque_.data() : samples.translucent_.data();
    const uint32_t* const i = &model.indices[3 * t];
    if (seen_[i[0]].z() >= near_ && seen_[i[1]].z() >= near_ && seen_[i[2]].z() >= near_)
      target.draw(t, points_[i[0]], points_[i[1]], points_[i[2]]);
    else
      draw_clipped(t, target, i);
  }
}

/// What lies before the near plane: a triangle or a quadrangle.
void Rasteriser::draw_clipped(uint32_t triangle, const Target& target, const uint32_t* corners) const {
  std::array<Point, 4> polygon;
  size_t count = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3f &a = seen_[corners[i]], &b = seen_[corners[(i + 1) % 3]];
    const bool a_before = a.z() >= near_, b_before = b.z() >= near_;
    if (a_before) polygon[count++] = projected(a);
    if (a_before == b_before) continue;
    Eigen::Vector3f cut = a + (b - a) * ((near_ - a.z()) / (b.z() - a.z()));
    cut.z() = near_;
    polygon[count++] = projected(cut);
  }
  for (size_t i = 2; i < count; ++i) target.draw(triangle, polygon[0], polygon[i - 1], polygon[i]);
}

/// Row by row the samples between the edges, which reach a little too far, so that nothing shows between two
/// triangles; of equal depths the first drawn stays.
void Rasteriser::Target::draw(uint32_t t, const Point& a, const Point& b, const Point& c) const {
  const Range columns(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), samples.x, samples.br().x - 1);
  const Range rows(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), samples.y, samples.br().y - 1);
  if (columns.first > columns.last || rows.first > rows.last) return;
  // In double: near the eye, corners lie far outside of the picture.
  const double area = (static_cast<double>(b.x) - a.x) * (static_cast<double>(c.y) - a.y) -
                      (static_cast<double>(c.x) - a.x) * (static_cast<double>(b.y) - a.y);
  if (area == 0) return;
  const auto x0 = static_cast<float>(columns.first), y0 = static_cast<float>(rows.first);
  const double inverse_area = 1 / area;
  const std::array<Share, 3> shares = {Share(c, a, inverse_area, x0, y0), Share(a, b, inverse_area, x0, y0),
                                       Share(b, c, inverse_area, x0, y0)};
  // Inverse depth is a plane over the picture.
  const float db = b.inverse - a.inverse, dc = c.inverse - a.inverse;
  const float depth_x = shares[0].along_x * db + shares[1].along_x * dc;
  const float depth_y = shares[0].along_y * db + shares[1].along_y * dc;
  const float depth_0 = a.inverse + shares[0].at_first * db + shares[1].at_first * dc;

  const RowsBetween between(shares, static_cast<float>(columns.last - columns.first));
  for (int y = rows.first; y <= rows.last; ++y) {
    const auto down = static_cast<float>(y - rows.first);
    const float low = between.low(down), high = between.high(down);
    if (low > high) continue;
    const size_t row = static_cast<size_t>(y - samples.y) * samples.width + (columns.first - samples.x);
    const float depth = depth_0 + down * depth_y;
    float* const nearest = inverse + row;
    uint32_t* const seen = triangle + row;
    const int end = static_cast<int>(high) + 1;
    for (int x = whole_above(low); x < end; ++x) {  // without branches, so that it becomes vectors
      const float at = depth + static_cast<float>(x) * depth_x;
      const uint32_t nearer = at > nearest[x] ? UINT32_MAX : 0;
      nearest[x] = std::max(nearest[x], at);
      seen[x] = (seen[x] & ~nearer) | (t & nearer);
    }
  }
}

}  // namespace svchain::car
