#include <algorithm>
#include <iostream>
#include <iterator>

#include "algorithms/calibration/print_charts.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

namespace fs = std::filesystem;

using calibration::Sheet;

/// charts.png and "front_left" make charts-front_left.png; what has no place in a file's name becomes "_".
fs::path picture_name(const fs::path& output, std::string chart) {
  for (char& c : chart) {
    if (c == '/' || (c >= 0 && c < ' ')) c = '_';
  }
  return output.parent_path() / (output.stem().string() + "-" + chart + output.extension().string());
}

/// The files to write, in the sheets' order: one PDF, or PNGs.
std::vector<fs::path> files_of(const fs::path& output, const std::vector<Sheet>& sheets) {
  if (output.extension() == ".pdf" || sheets.size() <= 1) return {output};
  std::vector<fs::path> files;
  files.reserve(sheets.size());
  for (const Sheet& sheet : sheets) files.push_back(picture_name(output, sheet.name));
  return files;
}

Faults output_faults(const fs::path& output, const std::vector<fs::path>& files) {
  const auto extension = output.extension();
  if (extension != ".pdf" && extension != ".png")
    return {{"--output", {}, {}, "expected a .pdf or .png file, got \"" + output.string() + "\""}};
  Faults faults;
  for (size_t i = 0; i < files.size(); ++i) {
    append(faults, check_writable(files[i], "--output"));
    if (std::count(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(i), files[i]) > 0)
      faults.push_back(
          {"--output", {}, {}, "two charts would be \"" + files[i].string() + "\", expected a .pdf"});
  }
  return faults;
}

}  // namespace

int print_charts(const ChartsOptions& options) {
  const auto charts =
      options.charts ? calibration::read_charts(*options.charts) : std::vector{calibration::usual_chart()};
  std::vector<Sheet> sheets;
  if (charts)
    std::transform(charts->begin(), charts->end(), std::back_inserter(sheets), calibration::sheet_of);
  const std::vector<fs::path> files = files_of(options.output, sheets);
  Faults faults = faults_of(charts);
  append(faults, output_faults(options.output, files));
  if (!faults.empty()) return say(faults);

  if (options.output.extension() == ".pdf") {
    write_whole(options.output, calibration::pdf_of(sheets));
  } else {
    for (size_t i = 0; i < files.size(); ++i) write_whole(files[i], calibration::png_of(sheets[i]));
  }
  for (const fs::path& file : files) std::cerr << "written: " << file.string() << '\n';
  return kDone;
}

}  // namespace svchain::program
