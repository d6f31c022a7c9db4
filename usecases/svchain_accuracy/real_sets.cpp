#include "usecases/svchain_accuracy/real_sets.h"

#include <opencv2/imgcodecs.hpp>

#include "algorithms/geometry/import_diy.h"

namespace svchain::accuracy {

namespace {

using calibration::CalibrationInput;
using std::filesystem::path;

path shipped(const std::string& folder, const std::string& name) {
  return path(SVCHAIN_SOURCE_DIR) / "configs" / folder / name;
}

Result<CalibrationInput> input_of(Result<geometry::Rig> rig, const path& charts_file,
                                  const std::vector<path>& pictures) {
  if (!rig) return tl::unexpected(rig.error());
  auto charts = calibration::read_charts(charts_file);
  if (!charts) return tl::unexpected(charts.error());
  CalibrationInput input;
  input.nominal = *std::move(rig);
  input.charts = *std::move(charts);
  for (const auto& file : pictures) {
    input.pictures.push_back(cv::imread(file.string()));
    if (input.pictures.back().empty()) return fail(file.string(), "cannot be read as a picture");
  }
  return input;
}

}  // namespace

Result<CalibrationInput> read_carpet(const path& data) {
  const path folder = data / "real_car_carpet";
  std::vector<path> yaml, pictures;
  for (const std::string name : {"front", "right", "back", "left"}) {
    yaml.push_back(folder / "yaml" / (name + ".yaml"));
    pictures.push_back(folder / "images" / (name + ".png"));
  }
  return input_of(geometry::import_diy(yaml), shipped("charts", "car_carpet.json"), pictures);
}

Result<CalibrationInput> read_garage(const path& data) {
  std::vector<path> pictures;
  for (const std::string& name : geometry::kCameraNames)
    pictures.push_back(data / "real_garage_lens_table" / "chessboard" / (name + ".png"));
  return input_of(geometry::read_rig(shipped("rigs", "garage.json")), shipped("charts", "garage.json"),
                  pictures);
}

}  // namespace svchain::accuracy
