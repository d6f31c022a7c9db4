#include "usecases/svchain_bench/growth.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <stdexcept>

#include "usecases/svchain_bench/library_hops.h"
#include "usecases/svchain_bench/our_hops.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

namespace {

constexpr std::array<std::array<int, 2>, 4> kSizesPx = {
    {{440, 540}, {880, 1080}, {1760, 2160}, {3520, 4320}}};
constexpr std::array kLineLinks = {1, 2, 4, 8, 16, 32, 64, 128, 256};
constexpr std::array kCameraCounts = {2, 4, 6, 8};

using Pictures = std::array<cv::Mat, 4>;

/// The same pictures in places of their own, more than caches hold: frames of a camera come from memory,
/// while LUTs stay where they are.
struct ArrivingFrames {
  explicit ArrivingFrames(const ParkedCar& car) {
    size_t set = 0;
    for (const cv::Mat& picture : car.pictures()) set += PoolMemory::room_for(picture.size(), picture.type());
    memory = PoolMemory(frames.size() * set);
    for (Pictures& pictures : frames)
      for (size_t camera = 0; camera < pictures.size(); ++camera)
        pictures[camera] = memory.place_copy(car.pictures()[camera]);
  }
  PoolMemory memory;
  std::array<Pictures, 16> frames;
};

double synthesis_ms(Kernels& kernels, std::span<const Pictures> frames, int count) {
  const int64_t start_ns = now_ns();
  for (int i = 0; i < count; ++i) kernels.synthesize(frames[static_cast<size_t>(i) % frames.size()]);
  return static_cast<double>(now_ns() - start_ns) * 1e-6 / count;
}

/// As many pixels of every size in turn.
std::vector<SizeCost> size_costs(const ParkedCar& car, std::span<const Pictures> frames) {
  constexpr int kRounds = 11, kLargestFrames = 2;
  geometry::View view = usual_view(car, {880, 1080});
  std::vector<SizeCost> costs;
  std::vector<std::unique_ptr<Kernels>> kernels;
  std::vector<std::vector<double>> rounds_ms(kSizesPx.size());
  for (const auto& [width_px, height_px] : kSizesPx) {
    view.size_px = {width_px, height_px};
    kernels.push_back(std::make_unique<Kernels>(car, view));
    costs.push_back({width_px, height_px, 0, static_cast<double>(kernels.back()->camera_pixels())});
  }
  for (int round = 0; round < kRounds; ++round)
    for (size_t i = 0; i < costs.size(); ++i) {
      const double smaller = costs.back().pixels() / costs[i].pixels();
      rounds_ms[i].push_back(synthesis_ms(*kernels[i], frames, static_cast<int>(kLargestFrames * smaller)));
    }
  for (size_t i = 0; i < costs.size(); ++i) costs[i].ms = median(rounds_ms[i]);
  return costs;
}

std::vector<LineCost> line_costs() {
  constexpr int kRounds = 11, kFewestFrames = 500, kLinkCalls = 200'000;
  const std::optional<Library> tbb = tbb_flow_graph();
  struct Rounds {
    std::vector<double> one, two, tbb;
  };
  std::vector<Rounds> rounds(kLineLinks.size());
  for (int round = 0; round < kRounds; ++round)
    for (size_t i = 0; i < rounds.size(); ++i) {
      const int links = kLineLinks[i];
      const int frames = std::max(kFewestFrames, kLinkCalls / (links + 10));
      rounds[i].one.push_back(chain_line_ns(links, 1, frames));
      rounds[i].two.push_back(chain_line_ns(links, 2, frames));
      if (tbb) rounds[i].tbb.push_back(tbb->line_ns(links, frames));
    }
  std::vector<LineCost> costs;
  costs.reserve(rounds.size());
  for (size_t i = 0; i < rounds.size(); ++i) {
    LineCost cost{kLineLinks[i], median(rounds[i].one), median(rounds[i].two), std::nullopt};
    if (tbb) cost.tbb_ns = median(rounds[i].tbb);
    costs.push_back(cost);
  }
  return costs;
}

/// What a link more costs a frame of so many buffers.
double hop_ns(int cores, int buffers) {
  constexpr int kLinks = 16, kFrames = 20'000;
  return (chain_line_ns(1 + kLinks, cores, kFrames, buffers) - chain_line_ns(1, cores, kFrames, buffers)) /
         kLinks;
}

double usual_synthesis_ms(const ParkedCar& car, std::span<const Pictures> frames) {
  constexpr int kRounds = 11;
  Kernels kernels(car, usual_view(car, {880, 1080}));
  std::vector<double> rounds_ms;
  for (int round = 0; round < kRounds; ++round)
    rounds_ms.push_back(synthesis_ms(kernels, frames, static_cast<int>(frames.size())));
  return median(rounds_ms);
}

std::vector<CameraCost> camera_costs(const ParkedCar& car, std::span<const Pictures> frames) {
  constexpr int kRounds = 7;
  struct Rounds {
    std::vector<double> one, two;
  };
  std::vector<Rounds> rounds(kCameraCounts.size());
  for (int round = 0; round < kRounds; ++round)
    for (size_t i = 0; i < rounds.size(); ++i) {
      rounds[i].one.push_back(hop_ns(1, kCameraCounts[i]));
      rounds[i].two.push_back(hop_ns(2, kCameraCounts[i]));
    }
  std::vector<CameraCost> costs;
  for (size_t i = 0; i < rounds.size(); ++i) {
    CameraCost cost{kCameraCounts[i], median(rounds[i].one), median(rounds[i].two), std::nullopt};
    if (static_cast<size_t>(cost.cameras) == car.pictures().size())
      cost.synthesis_ms = usual_synthesis_ms(car, frames);
    costs.push_back(cost);
  }
  return costs;
}

}  // namespace

double spread(const std::vector<double>& costs) {
  return quantile(costs, 1) / quantile(costs, 0);
}

std::vector<double> Growth::ns_per_pixel() const {
  std::vector<double> costs;
  for (const SizeCost& size : sizes) costs.push_back(size.ns_per_pixel());
  return costs;
}

std::vector<double> Growth::ns_per_camera_pixel() const {
  std::vector<double> costs;
  for (const SizeCost& size : sizes) costs.push_back(size.ns_per_camera_pixel());
  return costs;
}

Growth measure_growth(const Progress& progress) {
  const ParkedCar car;
  const ArrivingFrames arriving(car);
  Growth growth;
  progress("cost against output size");
  growth.sizes = size_costs(car, arriving.frames);
  progress("cost against cameras");
  growth.cameras = camera_costs(car, arriving.frames);
  progress("cost against links");
  growth.lines = line_costs();
  return growth;
}

}  // namespace svchain::bench
