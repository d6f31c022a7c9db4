// What a SOURCE text means.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "algorithms/scene/scene_file.h"
#include "links/capture/frame_source.h"
#include "links/capture/live_source.h"
#include "links/capture/numbered_source.h"
#include "links/capture/simulated_source.h"
#include "links/capture/source_folder.h"
#include "links/capture/stills_source.h"
#include "links/capture/video_source.h"
#include "links/quiet_opencv.h"

namespace svchain {

namespace {

constexpr std::string_view kSimulated = "simulated:";

struct NamedUrl {
  std::string name, url;
};

bool starts_a_camera(std::string_view text) {
  const std::string name(text.substr(0, text.find('=')));
  const auto& cameras = geometry::kCameraNames;
  return name.size() < text.size() &&
         (name == "back" || std::count(cameras.begin(), cameras.end(), name) > 0);
}

/// Splits at commas that a word and = follow directly: URLs may have commas themselves.
std::vector<NamedUrl> named_urls(const std::string& text) {
  std::vector<NamedUrl> found;
  for (size_t begin = 0; begin < text.size();) {
    size_t end = text.find(',', begin);
    while (end != std::string::npos) {
      const size_t word_end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", end + 1);
      if (word_end != std::string::npos && word_end > end + 1 && text[word_end] == '=') break;
      end = text.find(',', end + 1);
    }
    const std::string part = text.substr(begin, end == std::string::npos ? end : end - begin);
    const size_t equals = part.find('=');
    found.push_back({part.substr(0, equals), equals == std::string::npos ? "" : part.substr(equals + 1)});
    begin = end == std::string::npos ? text.size() : end + 1;
  }
  return found;
}

Result<std::unique_ptr<FrameSource>> open_named(const std::string& text) {
  std::array<std::string, kCameras> urls;
  Faults faults;
  const auto& names = geometry::kCameraNames;
  for (const NamedUrl& given : named_urls(text)) {
    const auto at = std::find(names.begin(), names.end(), given.name == "back" ? "rear" : given.name);
    if (at == names.end()) {
      faults.push_back({text, {}, "", "no camera \"" + given.name + "\"" + did_you_mean(given.name, names)});
    } else if (std::string& url = urls[static_cast<size_t>(at - names.begin())]; !url.empty()) {
      faults.push_back({text, {}, "", "camera \"" + *at + "\" is given twice"});
    } else {
      url = given.url;
    }
  }
  for (size_t c = 0; c < kCameras; ++c) {
    if (urls[c].empty()) faults.push_back({text, {}, "", "nothing for camera \"" + names[c] + "\""});
  }
  if (!faults.empty()) return tl::unexpected(faults);
  return open_live(urls);
}

Result<std::unique_ptr<FrameSource>> open_folder(const std::string& path, const SourceRequest& request) {
  const auto folder = look_into_folder(path);
  if (!folder) return tl::unexpected(folder.error());
  switch (folder->kind) {
    case FolderKind::kStills:
      return open_stills(*folder, request);
    case FolderKind::kNumbered:
      return open_numbered(*folder, request);
    case FolderKind::kVideos:
      break;
  }
  return open_videos(*folder, request);
}

}  // namespace

bool is_live_source(const std::string& source) {
  return starts_a_camera(source);
}

std::optional<double> source_fps(const std::string& source) {
  quiet_opencv();
  if (source.starts_with(kSimulated)) {
    const auto path = find_scene(source.substr(kSimulated.size()));
    const auto scene = path ? scene::read_scene(*path) : tl::unexpected(path.error());
    return scene ? std::optional(scene->frame_rate_hz) : std::nullopt;
  }
  if (is_live_source(source)) return std::nullopt;
  const auto folder = look_into_folder(source);
  return folder && folder->kind == FolderKind::kVideos ? video_fps(*folder) : std::nullopt;
}

Result<std::unique_ptr<FrameSource>> open_source(const std::string& source, const SourceRequest& request) {
  quiet_opencv();
  if (source.empty()) {
    return fail("input",
                "is empty, expected a directory, simulated:SCENE, or front=URL,right=URL,rear=URL,left=URL");
  }
  if (source.starts_with(kSimulated)) return open_simulated(source.substr(kSimulated.size()), request);
  return is_live_source(source) ? open_named(source) : open_folder(source, request);
}

int64_t nominal_time_ns(uint64_t set, double fps) {
  return std::llround(static_cast<double>(set) * 1e9 / fps);
}

}  // namespace svchain
