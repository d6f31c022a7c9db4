#pragma once
// The geometric LUT of the paper with its blending LUT: where in which camera every pixel of the composite
// comes from. One flat, position-independent block of bytes (offsets, no pointers), because it travels
// between cores in a pool buffer. Shape: a header, the table of the composite's 40x40 blocks (row by row;
// those at the right and lower edge may be smaller), then each block's content. A block is cut into regions,
// which show the same: black, background, one camera, or the blend of two. A region's pixels lie one after
// the other, row by row, whatever columns they have, so that a kernel runs through them without a gap. Five
// lists, walked in parallel:
//   regions     at most one of each kind and sources
//   spans       the runs of pixels of one row that a region consists of
//   entries     where to sample, as fixed_point.h defines, relative to the source's box: one for every pixel
//   of a
//               region of one camera; of a blend first all for its first camera, then all for its second
//   weights     one for every pixel of a blend: the share of its first camera in 255ths
//   background  b g r for every pixel of background
// and, for prefetching, rows: what the block takes of every row of its first source's box, then of its
// second's ... It is empty where the boxes have more than 512 rows together. A source is a camera with the
// box (in the camera's image) that tightly encloses the pixels this block takes from it, both neighbours of
// bilinear samples included; a box is at most 2048 px wide and high.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "algorithms/geometry/ray_from_ground.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/geometry/view.h"
#include "algorithms/synthesis/blend_shape.h"

namespace svchain::synthesis {

inline constexpr int kBlockSize = 40;
inline constexpr int kLargestBox = 2048;
inline constexpr uint32_t kMostRows = 512;
inline constexpr uint32_t kLutMagic = 0x54554c47;  // "GLUT"
inline constexpr uint32_t kLutVersion = 3;

enum class RegionKind : uint8_t { kBlack, kBackground, kCamera, kBlend };

struct LutRegion {
  RegionKind kind;
  uint8_t first;   // index of the source; the clockwise first of the two in a blend
  uint8_t second;  // likewise, in a blend only
  uint8_t unused;  // 0, so that equal LUTs are equal byte by byte
  uint16_t span_count;
  uint16_t pixels;

  int tap_count() const { return kind == RegionKind::kBlend ? 2 : kind == RegionKind::kCamera ? 1 : 0; }
};

struct LutSpan {
  uint8_t row;    // in the block
  uint8_t start;  // first column in the block
  uint8_t count;
};

struct LutSource {
  uint16_t camera;
  uint16_t x, y, width, height;  // the box, px
};

/// From the first to the last pixel that a block takes of one row of a source's box.
struct LutRow {
  uint16_t start, count;  // px, start from the box's left side
};

/// Where in their images two blended cameras see a block: mean of q^2 over the pixels that blend, q being the
/// distance from the lens's centre in half image widths.
struct LutOverlap {
  float q2_first, q2_second;
};

struct LutBlock {
  uint16_t x, y, width, height;  // in the composite, px
  uint32_t source_count;
  std::array<LutSource, 4> sources;    // by rising camera number
  std::array<LutOverlap, 4> overlaps;  // by the source that is the clockwise first of a pair
  uint32_t first_overlap;              // how many overlaps the blocks before it have
  uint32_t regions_at, region_count;   // offsets in bytes from the LUT's start
  uint32_t spans_at, span_count;
  uint32_t entries_at, entry_count;
  uint32_t weights_at, weight_count;
  uint32_t background_at, background_count;
  uint32_t rows_at, row_count;

  bool blends() const { return weight_count > 0; }
};

struct LutHeader {
  uint32_t magic;
  uint32_t version;
  uint32_t bytes;  // of the whole LUT
  uint32_t camera_count;
  uint32_t block_count;
  uint32_t overlap_count;  // blocks times pairs of cameras blended in them
  int32_t width, height;   // of the composite, px
  double metres_per_px;
  double centre_m[2];
  std::array<std::array<int32_t, 2>, 4> image_size_px;
  std::array<std::array<int32_t, 2>, 4> lens_centre;  // 1/32 px
};

/// Blocks of a composite of this size.
size_t block_count(const Eigen::Vector2i& size_px);

/// Bytes that are enough for the LUT of any rig at this view.
size_t geometric_lut_capacity(const geometry::View& view, size_t cameras);

/// How each of four cameras sees the ground: (x, y, 1), metres, to a ray in the camera's frame, up to a
/// factor above 0.
using RaysFromGround = std::array<Eigen::Matrix3d, 4>;

/// As the poses of a rig of four cameras say.
RaysFromGround rays_from_ground(const geometry::Rig& rig);

/// Writes the LUT of a rig of four cameras into memory (aligned to 8 bytes) and returns the bytes used. What
/// is under the vehicle shows its silhouette, what nobody sees is black. Throws std::invalid_argument, naming
/// the culprit, where there are not four cameras, the blend's width is out of range, the memory does not
/// suffice, or a block would need a box above 2048 px.
size_t build_geometric_lut(const geometry::Rig& rig, const geometry::View& view, const BlendShape& shape,
                           std::span<std::byte> memory);
/// The same by matrices that need not be those of rigid cameras (2D alignment). They alone say where a camera
/// sees the ground; the rig gives lenses, image sizes and what the vehicle hides from where a camera is.
size_t build_geometric_lut(const geometry::Rig& rig, const RaysFromGround& rays, const geometry::View& view,
                           const BlendShape& shape, std::span<std::byte> memory);

/// Reads a LUT in place. Borrows the memory; any number of threads.
class GeometricLut {
 public:
  /// Throws std::invalid_argument for memory that holds no LUT of this version or a truncated one, and where
  /// a list or box leaves its bounds. Entries are taken on trust.
  explicit GeometricLut(std::span<const std::byte> memory);

  const LutHeader& header() const { return *at<LutHeader>(0); }
  std::span<const LutBlock> blocks() const { return {at<LutBlock>(sizeof(LutHeader)), header().block_count}; }

  std::span<const LutRegion> regions(const LutBlock& b) const {
    return {at<LutRegion>(b.regions_at), b.region_count};
  }
  std::span<const LutSpan> spans(const LutBlock& b) const { return {at<LutSpan>(b.spans_at), b.span_count}; }
  std::span<const LutRow> rows(const LutBlock& b) const { return {at<LutRow>(b.rows_at), b.row_count}; }
  const uint32_t* entries(const LutBlock& b) const { return at<uint32_t>(b.entries_at); }
  const uint8_t* weights(const LutBlock& b) const { return at<uint8_t>(b.weights_at); }
  const uint8_t* background(const LutBlock& b) const { return at<uint8_t>(b.background_at); }

  struct Footprint {
    size_t bytes = 0;
    double bytes_per_pixel = 0;    // of the composite
    size_t empty_blocks = 0;       // no camera
    size_t one_camera_blocks = 0;  // no pixel with more than one
    size_t blend_blocks = 0;
    size_t source_pixels = 0;  // sum of all boxes: what a block-wise DMA would fetch
  };
  Footprint footprint() const;

 private:
  template <class T>
  const T* at(size_t offset) const {
    return reinterpret_cast<const T*>(memory_.data() + offset);
  }
  void check_block(const LutBlock& block) const;
  bool regions_fit(const LutBlock& block) const;
  bool rows_fit(const LutBlock& block) const;

  std::span<const std::byte> memory_;
};

}  // namespace svchain::synthesis
