#include <Eigen/Core>
#include <algorithm>
#include <iostream>

#include "algorithms/geometry/import_diy.h"
#include "algorithms/geometry/import_lens_table.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

using geometry::Rig;

const std::vector<std::string> kFormats = {"diy", "lens_table_homography"};

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

Result<Rig> read_any(const ImportOptions& options, const geometry::DiyCanvas& canvas) {
  if (options.format == "diy") return geometry::import_diy(options.files, canvas);
  if (options.format == "lens_table_homography") return geometry::import_lens_table(options.files);
  return fail("import", "the format \"" + options.format + "\" is not available yet" +
                            did_you_mean(options.format, kFormats) + " (there are " + spoken_list(kFormats) +
                            ")");
}

}  // namespace

int import_rig(const ImportOptions& options) {
  Faults faults;
  const auto canvas = canvas_of(options, faults);
  const auto rig = read_any(options, canvas);
  if (!rig) append(faults, rig.error());
  append(faults, check_writable(options.output, "--output"));
  if (!faults.empty()) return say(faults);
  write_whole(options.output, geometry::rig_text(*rig));
  std::cerr << options.output.string() << ": " << rig->cameras.size() << " cameras\n";
  return kDone;
}

}  // namespace svchain::program
