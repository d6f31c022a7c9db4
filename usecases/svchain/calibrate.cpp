#include <algorithm>
#include <csignal>
#include <ctime>
#include <iostream>

#include "algorithms/calibration/calibration.h"
#include "algorithms/calibration/calibration_json.h"
#include "algorithms/calibration/calibration_pictures.h"
#include "algorithms/calibration/clicked_corners.h"
#include "algorithms/calibration/content_start.h"
#include "usecases/svchain/calibration_table.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/four_pictures.h"
#include "usecases/svchain/new_folder.h"
#include "usecases/svchain/png_text.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

namespace fs = std::filesystem;

using calibration::Calibration;
using calibration::CalibrationInput;
using calibration::HoldOut;

constexpr const char* kToStdout = "-";

Fault missing(const std::string& option, const std::string& expected) {
  return {option, {}, {}, "is missing, expected " + expected};
}

/// Which of the names an option gives: its index; without one, or after a fault, nothing.
std::optional<size_t> read_choice(const std::string& option, const std::optional<std::string>& given,
                                  const std::vector<std::string>& names, Faults& faults) {
  if (!given) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), *given);
  if (found != names.end()) return static_cast<size_t>(found - names.begin());
  faults.push_back(
      {option,
       {},
       {},
       "expected " + spoken_list(names) + ", got \"" + *given + "\"" + did_you_mean(*given, names)});
  return std::nullopt;
}

HoldOut read_hold_out(const std::optional<std::string>& given, Faults& faults) {
  const auto which = read_choice("--hold-out", given, {"even", "odd"}, faults);
  if (!which) return HoldOut::kNone;
  return *which == 0 ? HoldOut::kEven : HoldOut::kOdd;
}

bool starts_from_content(const CalibrateOptions& options, Faults& faults) {
  const bool content = read_choice("--start", options.start, {"nominal", "content"}, faults) == 1;
  if (content && !options.images)
    faults.push_back({"--start", {}, {}, "content is what pictures show: expected --images DIR"});
  return content;
}

/// What was read, or a value without content after its faults: so the other files' are found as well.
template <class T>
T taken(Result<T> read, Faults& faults) {
  append(faults, faults_of(read));
  return read ? std::move(*read) : T{};
}

CalibrationInput read_input(const CalibrateOptions& options, Faults& faults) {
  CalibrationInput input;
  input.hold_out = read_hold_out(options.hold_out, faults);
  if (options.rig) {
    input.nominal = taken(geometry::read_rig(*options.rig), faults);
  } else {
    faults.push_back(missing("--rig", "the nominal rig's file"));
  }
  if (options.charts) {
    input.charts = taken(calibration::read_charts(*options.charts), faults);
  } else {
    faults.push_back(missing("--charts", "the file of what lies on the ground"));
  }
  if (options.corners)
    input.clicked =
        taken(calibration::read_clicked_corners(*options.corners, input.nominal, input.charts), faults);
  if (options.images) {
    input.pictures = taken(read_four_pictures(*options.images, input.nominal), faults);
  } else if (!options.corners) {
    faults.push_back(missing("--images", "the pictures' folder, or --corners FILE.json"));
  }
  return input;
}

Faults output_faults(const CalibrateOptions& options) {
  Faults faults;
  if (options.output) {
    append(faults, check_writable(*options.output, "--output"));
  } else {
    faults.push_back(missing("--output", "the calibrated rig's file"));
  }
  if (options.report && *options.report != kToStdout) {
    append(faults, check_writable(*options.report, "--report"));
    if (options.output && fs::weakly_canonical(*options.report) == fs::weakly_canonical(*options.output))
      faults.push_back({"--report", {}, {}, "is the same file as --output"});
  }
  if (options.pictures) {
    append(faults, NewFolder::check(*options.pictures, "--pictures"));
    if (!options.images) faults.push_back({"--pictures", {}, {}, "draws on pictures: expected --images DIR"});
  }
  return faults;
}

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

/// Of a rejected calibration only what was found: its rig is good for nothing.
void write_pictures(const fs::path& path, const CalibrationInput& input, const Calibration& calibration) {
  NewFolder folder(path);
  for (size_t c = 0; c < calibration.cameras.size(); ++c)
    folder.write(geometry::kCameraNames[c] + ".png",
                 png_text(calibration::corners_picture(input.pictures[c], c, calibration)));
  if (calibration.accepted())
    folder.write("stitched.png", png_text(calibration::stitched_picture(input.pictures, calibration)));
  folder.keep();
}

void write_all(const CalibrateOptions& options, const CalibrationInput& input, Calibration& calibration) {
  const std::string date = now_utc();
  if (options.pictures) write_pictures(*options.pictures, input, calibration);
  if (options.report) {
    const std::string report = calibration::report_text(input, {}, calibration, date);
    if (*options.report == kToStdout) {
      std::cout << report << std::flush;
    } else {
      write_whole(*options.report, report);
    }
  }
  if (!calibration.accepted()) return;
  calibration.rig.calibration = calibration::rig_part(calibration, date);
  write_whole(*options.output, geometry::rig_text(calibration.rig));
}

}  // namespace

int calibrate(const CalibrateOptions& options) {
  Faults faults;
  CalibrationInput input = read_input(options, faults);
  const bool content = starts_from_content(options, faults);
  append(faults, output_faults(options));
  if (!faults.empty()) return say(faults);

  if (content) calibration::start_from_content(input);
  Calibration made = calibration::calibrate(input);
  // Until here Ctrl-C leaves nothing behind; the rest is done in a moment.
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);
  std::cerr << calibration_table(made);
  write_all(options, input, made);
  if (made.accepted()) {
    std::cerr << options.output->string() << ": calibrated\n";
    return kDone;
  }
  say(reasons_of(made));
  std::cerr << "svchain: error: the calibration is rejected, no rig is written\n";
  return kFailed;
}

}  // namespace svchain::program
