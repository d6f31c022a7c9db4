// What a PATH means, and whether it can be written.

#include <unistd.h>

#include "links/display/frame_writer.h"
#include "links/display/png_writer.h"
#include "links/display/video_writer.h"
#include "links/display/window_writer.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

/// "" where something new can be made in the folder.
std::string folder_fault(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return "the folder " + folder.string() + " does not exist";
  if (!fs::is_directory(folder, ignored)) return folder.string() + " is not a folder";
  if (access(folder.c_str(), W_OK) != 0) return "the folder " + folder.string() + " is not writable";
  return "";
}

}  // namespace

Result<std::unique_ptr<FrameWriter>> make_writer(const std::string& output, const WriterRequest& request) {
  if (output == "none") return std::unique_ptr<FrameWriter>();
  if (output == "window") return make_window_writer();
  if (output.empty())
    return fail("output", "is empty, expected a .png, .mp4 or .mkv file, a directory, window or none");

  fs::path path = output;
  if (!path.has_filename()) path = path.parent_path();  // a trailing slash
  std::error_code ignored;
  const bool is_folder = fs::is_directory(path, ignored);
  const std::string extension = path.extension().string();
  const std::string fault = folder_fault(is_folder                ? path
                                         : path.has_parent_path() ? path.parent_path()
                                                                  : fs::path("."));
  if (!fault.empty()) return fail(output, fault);
  if (is_folder && extension != ".png" && extension != ".mp4" && extension != ".mkv")
    return make_folder_writer(path);
  if (is_folder) return fail(output, "is a folder, expected a " + extension + " file to be written");
  if (extension == ".png") return make_last_frame_writer(path);
  if (extension == ".mp4" || extension == ".mkv") return make_video_writer(path, request);
  if (!extension.empty()) {
    return fail(output,
                "unknown file type \"" + extension +
                    "\", expected .png, .mp4, .mkv, or a name without one for a directory of pictures");
  }
  if (fs::exists(path, ignored)) return fail(output, "is a file, expected a directory");
  return make_folder_writer(path);
}

}  // namespace svchain
