#include "links/capture/source_folder.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "links/capture/image_file.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

const std::set<std::string> kVideoExtensions = {".mp4", ".mkv", ".avi",  ".mov", ".m4v",
                                                ".ts",  ".mpg", ".mpeg", ".webm"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::optional<FolderKind> kind_of(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return FolderKind::kNumbered;
  if (is_image_name(path)) return FolderKind::kStills;
  if (kVideoExtensions.contains(lower(path.extension().string()))) return FolderKind::kVideos;
  return std::nullopt;
}

const char* spoken(FolderKind kind) {
  switch (kind) {
    case FolderKind::kStills:
      return "a still image";
    case FolderKind::kNumbered:
      return "a folder of frames";
    case FolderKind::kVideos:
      return "a video";
  }
  return "";
}

struct Found {
  std::vector<fs::path> usable;
  std::vector<fs::path> other;
};

Found find_camera(const std::vector<fs::path>& entries, const std::string& camera) {
  Found found;
  for (const fs::path& entry : entries) {
    const bool folder = kind_of(entry) == FolderKind::kNumbered;
    const std::string name = lower(folder ? entry.filename().string() : entry.stem().string());
    if (name != camera && !(camera == "rear" && name == "back")) continue;
    (kind_of(entry) ? found.usable : found.other).push_back(entry);
  }
  return found;
}

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    entries.push_back(at->path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::string missing_text(const std::string& camera, const fs::path& folder, const Found& found) {
  if (!found.other.empty()) {
    return camera + ": " + found.other.front().filename().string() +
           " is neither an image (.png, .jpg, .jpeg, .bmp), a video nor a folder of numbered frames";
  }
  std::string text = "nothing for camera \"" + camera + "\", expected " + camera + ".png (.jpg, .bmp), " +
                     camera + ".mp4 or a folder " + camera + "/";
  std::error_code ignored;
  if (fs::is_directory(folder / "images", ignored))
    text += "; did you mean \"" + (folder / "images").string() + "\"?";
  return text;
}

}  // namespace

Result<SourceFolder> look_into_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return fail(folder.string(), "no such directory");
  if (!fs::is_directory(folder, ignored)) {
    return fail(folder.string(), "is a file, expected a directory with front, right, rear and left");
  }
  const std::vector<fs::path> entries = sorted_entries(folder);
  Faults faults;
  SourceFolder source;
  for (size_t c = 0; c < kCameras; ++c) {
    const std::string& camera = geometry::kCameraNames[c];
    const Found found = find_camera(entries, camera);
    if (found.usable.empty()) {
      faults.push_back({folder.string(), {}, "", missing_text(camera, folder, found)});
    } else if (found.usable.size() > 1) {
      faults.push_back({folder.string(),
                        {},
                        "",
                        camera + ": both " + found.usable[0].filename().string() + " and " +
                            found.usable[1].filename().string() + " are there, expected one of them"});
    } else {
      source.paths[c] = found.usable.front();
    }
  }
  if (!faults.empty()) return tl::unexpected(faults);
  source.kind = *kind_of(source.paths[0]);
  for (size_t c = 1; c < kCameras; ++c) {
    const FolderKind kind = *kind_of(source.paths[c]);
    if (kind == source.kind) continue;
    faults.push_back({folder.string(),
                      {},
                      "",
                      geometry::kCameraNames[c] + " is " + spoken(kind) + ", but front is " +
                          spoken(source.kind) + ": all four have to be of one kind"});
  }
  if (!faults.empty()) return tl::unexpected(faults);
  return source;
}

}  // namespace svchain
