#include "usecases/svchain/four_pictures.h"

#include "links/capture/frame_source.h"
#include "links/capture/source_folder.h"
#include "usecases/svchain/say_faults.h"

namespace svchain::program {

namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

Faults size_faults(const std::filesystem::path& folder, const SourceFacts& facts, const geometry::Rig& rig) {
  Faults faults;
  for (size_t c = 0; c < rig.cameras.size(); ++c) {
    const cv::Size got = facts.size_px[c];
    const Eigen::Vector2i expected = rig.cameras[c].image_size_px;
    if (got.width == expected.x() && got.height == expected.y()) continue;
    faults.push_back({folder.string(),
                      {},
                      {},
                      rig.cameras[c].name + "'s picture is " + size_text(got.width, got.height) +
                          " px, the nominal rig expects " + size_text(expected.x(), expected.y())});
  }
  return faults;
}

}  // namespace

Result<std::vector<cv::Mat>> read_four_pictures(const std::filesystem::path& folder,
                                                const geometry::Rig& rig) {
  if (const auto looked = look_into_folder(folder); !looked) return tl::unexpected(looked.error());
  // Whatever its name, a whole path is taken for a folder.
  const auto source = open_source(std::filesystem::absolute(folder).string(), {});
  if (!source) return tl::unexpected(source.error());
  const SourceFacts& facts = (*source)->facts();
  Faults faults = size_faults(folder, facts, rig);
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  std::vector<cv::Mat> pictures;
  (*source)->start();
  for (size_t c = 0; c < kCameras; ++c) {
    cv::Mat picture(facts.size_px[c], CV_8UC3);
    (*source)->read(0, c, picture);
    pictures.push_back(picture);
  }
  (*source)->stop();
  return pictures;
}

}  // namespace svchain::program
