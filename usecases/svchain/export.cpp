#include <algorithm>
#include <iostream>

#include "algorithms/geometry/export_rig.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

using geometry::Rig;
using geometry::TextFile;

struct Format {
  const char* name;
  Result<std::vector<TextFile>> (*write)(const Rig&);
};
constexpr Format kFormats[] = {{"kalibr", geometry::export_kalibr}, {"ros", geometry::export_ros}};

/// The files of the format, faults being told of the rig's file.
Result<std::vector<TextFile>> files_of(const ExportOptions& options) {
  auto rig = geometry::read_rig(options.rig);
  Faults faults = faults_of(rig);
  std::vector<std::string> names;
  for (const Format& format : kFormats) {
    names.push_back(format.name);
    if (options.format != format.name || !rig) continue;
    auto files = format.write(*rig);
    if (files) return files;
    for (Fault& fault : files.error()) fault.file = options.rig.string();
    return files;
  }
  if (std::find(names.begin(), names.end(), options.format) == names.end()) {
    faults.push_back({"export",
                      {},
                      {},
                      "unknown format \"" + options.format + "\"" + did_you_mean(options.format, names) +
                          " (there are " + spoken_list(names) + ")"});
  }
  return tl::unexpected(std::move(faults));
}

}  // namespace

int export_rig(const ExportOptions& options) {
  const auto files = files_of(options);
  if (!files) return say(files.error());
  std::error_code error;
  std::filesystem::create_directories(options.output, error);
  if (error) return say({{"--output", {}, {}, options.output.string() + ": " + error.message()}});
  Faults faults;
  for (const TextFile& file : *files) append(faults, check_writable(options.output / file.name, "--output"));
  if (!faults.empty()) return say(faults);
  for (const TextFile& file : *files) write_whole(options.output / file.name, file.text);
  std::cerr << options.output.string() << ": " << files->size()
            << (files->size() == 1 ? " file\n" : " files\n");
  return kDone;
}

}  // namespace svchain::program
