#include <Eigen/Core>
#include <algorithm>
#include <iostream>

#include "algorithms/geometry/import_diy.h"
#include "algorithms/geometry/import_kalibr.h"
#include "algorithms/geometry/import_lens_table.h"
#include "algorithms/geometry/import_ocam.h"
#include "algorithms/geometry/import_ros.h"
#include "algorithms/geometry/import_woodscape.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

using geometry::Rig;

void take(Eigen::Vector2i& value, const std::optional<std::vector<int>>& given) {
  if (given) value = {given->at(0), given->at(1)};
}

geometry::DiyCanvas canvas_of(const ImportOptions& options, Faults& faults) {
  geometry::DiyCanvas canvas;
  take(canvas.size_px, options.canvas_size_px);
  take(canvas.car_min_px, options.car_min_px);
  take(canvas.car_max_px, options.car_max_px);
  canvas.metres_per_px = options.canvas_metres_per_px.value_or(canvas.metres_per_px);
  const bool ordered = canvas.car_min_px.minCoeff() >= 0 &&
                       (canvas.car_min_px.array() < canvas.car_max_px.array()).all() &&
                       (canvas.car_max_px.array() <= canvas.size_px.array()).all();
  if (!ordered) {
    faults.push_back(
        {"--car-min-px, --car-max-px", {}, {}, "expected a rectangle within the canvas, least corner first"});
  }
  if (!(canvas.metres_per_px > 0 && canvas.metres_per_px <= 1)) {
    faults.push_back({"--canvas-metres-per-px", {}, {}, "expected more than 0, at most 1"});
  }
  return canvas;
}

/// What a format's files are read with.
struct Sources {
  std::vector<std::filesystem::path> files;
  geometry::DiyCanvas canvas;
  Rig nominal;
};

struct Format {
  std::string name;
  std::string untold;  // what its files do not say and a nominal rig must
  Result<Rig> (*read)(const Sources&);
};

const std::string kVehicleAndPoses = "the vehicle's size and where its cameras are";

/// Every format there is.
const std::vector<Format>& formats() {
  static const std::vector<Format> kFormats = {
      {"diy", "", [](const Sources& s) { return geometry::import_diy(s.files, s.canvas); }},
      {"lens_table_homography", "", [](const Sources& s) { return geometry::import_lens_table(s.files); }},
      {"kalibr", kVehicleAndPoses,
       [](const Sources& s) { return geometry::import_kalibr(s.files, s.nominal); }},
      {"ros", kVehicleAndPoses, [](const Sources& s) { return geometry::import_ros(s.files, s.nominal); }},
      {"woodscape", "the vehicle's size",
       [](const Sources& s) { return geometry::import_woodscape(s.files, s.nominal); }},
      {"ocam", kVehicleAndPoses, [](const Sources& s) { return geometry::import_ocam(s.files, s.nominal); }},
  };
  return kFormats;
}

Result<const Format*> find_format(const std::string& name) {
  std::vector<std::string> names;
  for (const Format& format : formats()) {
    if (format.name == name) return &format;
    names.push_back(format.name);
  }
  return fail("import", "unknown format \"" + name + "\"" + did_you_mean(name, names) + " (there are " +
                            spoken_list(names) + ")");
}

/// The nominal rig that the format needs. After a fault, one without content: so the faults of the files are
/// found as well.
Rig nominal_for(const Format& format, const std::optional<std::filesystem::path>& given, Faults& faults) {
  Rig stand_in;
  for (const std::string& name : geometry::kCameraNames) {
    stand_in.cameras.push_back({name, {0, 0}, nullptr, {}});
  }
  if (!given && !format.untold.empty()) {
    faults.push_back({"--rig",
                      {},
                      {},
                      "the format \"" + format.name + "\" does not tell " + format.untold +
                          ": expected --rig NOMINAL.json"});
  }
  if (given && format.untold.empty()) {
    faults.push_back(
        {"--rig", {}, {}, "means nothing for the format \"" + format.name + "\", whose files tell all"});
  }
  if (!given) return stand_in;
  auto nominal = geometry::read_rig(*given);
  if (nominal) {
    nominal->calibration.clear();  // other lenses or poses: it does not hold any more
    return std::move(*nominal);
  }
  append(faults, nominal.error());
  return stand_in;
}

/// Reads everything, so that all faults are told at once.
Result<Rig> read_all(const ImportOptions& options) {
  Faults faults;
  Sources sources{options.files, canvas_of(options, faults), {}};
  const auto format = find_format(options.format);
  if (!format) {
    append(faults, format.error());
    return tl::unexpected(std::move(faults));
  }
  sources.nominal = nominal_for(**format, options.rig, faults);
  auto rig = (*format)->read(sources);
  append(faults, faults_of(rig));
  if (faults.empty()) return rig;
  return tl::unexpected(std::move(faults));
}

}  // namespace

int import_rig(const ImportOptions& options) {
  const auto rig = read_all(options);
  Faults faults = faults_of(rig);
  append(faults, check_writable(options.output, "--output"));
  if (!faults.empty()) return say(faults);
  const std::string text = geometry::rig_text(*rig);
  // Lenses that no rig may have, a picture that folds at once for one, must not become a file.
  if (const auto again = geometry::parse_rig(text, "import"); !again) return say(again.error());
  write_whole(options.output, text);
  std::cerr << options.output.string() << ": " << rig->cameras.size() << " cameras\n";
  return kDone;
}

}  // namespace svchain::program
