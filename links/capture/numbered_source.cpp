#include "links/capture/numbered_source.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "links/capture/image_file.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

std::string size_text(cv::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// The last run of digits in a name, without leading zeros: longer is larger, then the text decides.
std::string number_in(const fs::path& path) {
  const std::string stem = path.stem().string();
  size_t end = stem.size();
  while (end > 0 && !std::isdigit(static_cast<unsigned char>(stem[end - 1]))) --end;
  size_t begin = end;
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(stem[begin - 1]))) --begin;
  while (begin < end && stem[begin] == '0') ++begin;
  return stem.substr(begin, end - begin);
}

bool before(const fs::path& a, const fs::path& b) {
  const std::string na = number_in(a), nb = number_in(b);
  if (na.size() != nb.size()) return na.size() < nb.size();
  return na != nb ? na < nb : a < b;
}

std::vector<fs::path> frames_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    const fs::path path = at->path();
    if (path.filename().string().front() != '.' && is_image_name(path)) files.push_back(path);
  }
  std::sort(files.begin(), files.end(), before);
  return files;
}

class NumberedSource final : public FrameSource {
 public:
  NumberedSource(std::array<std::vector<fs::path>, kCameras> files,
                 const std::array<cv::Size, kCameras>& sizes, double fps)
      : fps_(fps), files_(std::move(files)) {
    facts_.size_px = sizes;
    facts_.sets = facts_.usual_sets = files_[0].size();
  }

  const SourceFacts& facts() const override { return facts_; }
  std::optional<int64_t> read(uint64_t set, size_t camera, cv::Mat& into) override {
    const fs::path& path = files_[camera][set];
    cv::Mat image = into;
    try {
      read_image(path, image);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(where(camera, set) + error.what());
    }
    if (image.size() != into.size()) {
      throw std::runtime_error(where(camera, set) + "is " + size_text(image.size()) +
                               " px, those before were " + size_text(into.size()));
    }
    return nominal_time_ns(set, fps_);
  }
  int64_t time_ns(uint64_t set, size_t) const override { return nominal_time_ns(set, fps_); }

 private:
  std::string where(size_t camera, uint64_t set) const {
    return geometry::kCameraNames[camera] + " frame " + std::to_string(set) + ": " +
           files_[camera][set].string() + " ";
  }

  double fps_;
  std::array<std::vector<fs::path>, kCameras> files_;
  SourceFacts facts_;
};

void check_files(const std::vector<fs::path>& files, cv::Size& first_size, Faults& faults) {
  for (const fs::path& file : files) {
    if (const std::string damage = image_damage(file); !damage.empty())
      faults.push_back({file.string(), {}, "", damage});
  }
  if (!faults.empty()) return;
  try {
    cv::Mat image;
    read_image(files.front(), image);
    first_size = image.size();
  } catch (const std::runtime_error& error) {
    faults.push_back({files.front().string(), {}, "", error.what()});
  }
}

}  // namespace

Result<std::unique_ptr<FrameSource>> open_numbered(const SourceFolder& folder, const SourceRequest& request) {
  std::array<std::vector<fs::path>, kCameras> files;
  std::array<cv::Size, kCameras> sizes;
  Faults faults;
  for (size_t c = 0; c < kCameras; ++c) {
    Faults found;
    files[c] = frames_in(folder.paths[c]);
    if (files[c].empty()) {
      found.push_back(
          {folder.paths[c].string(), {}, "", "holds no frames, expected images such as 000000.png"});
    } else {
      check_files(files[c], sizes[c], found);
    }
    faults.insert(faults.end(), found.begin(), found.end());
    if (found.empty() && !files[0].empty() && files[c].size() != files[0].size()) {
      faults.push_back({folder.paths[c].string(),
                        {},
                        "",
                        geometry::kCameraNames[c] + " has " + std::to_string(files[c].size()) +
                            " frames, front has " + std::to_string(files[0].size())});
    }
  }
  if (!faults.empty()) return tl::unexpected(faults);
  return std::make_unique<NumberedSource>(std::move(files), sizes, request.fps);
}

}  // namespace svchain
