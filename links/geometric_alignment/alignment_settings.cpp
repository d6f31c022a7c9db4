#include "links/geometric_alignment/alignment_settings.h"

#include <filesystem>
#include <system_error>
#include <unistd.h>

#include "algorithms/synthesis/lut_file.h"
#include "links/geometric_alignment/charts_alignment.h"
#include "links/surround_settings.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

constexpr const char *kSmooth = "smooth", *kLinear = "linear", *kBinary = "binary";
constexpr const char* kMadeHere = "rig, nominal, charts or features";  // sources that make a LUT

/// "" where a file of this name can be made.
std::string store_fault(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (fs::is_directory(path, ignored)) return path.string() + " is a folder, expected a file to be written";
  if (!fs::is_directory(folder, ignored)) return "the folder " + folder.string() + " does not exist";
  if (access(folder.c_str(), W_OK) != 0) return "the folder " + folder.string() + " is not writable";
  return "";
}

/// What differs from the usual blend is expected of a stored LUT in vain: it keeps its own.
template <class Unused>
void check_blend(const Parameters& given, const Unused& unused) {
  if (given.number("blend_deg") != synthesis::BlendShape{}.width_deg) unused("blend_deg", kMadeHere);
  if (given.text("blend_shape") != kSmooth) unused("blend_shape", kMadeHere);
}

/// Parameters that this source would not look at are faults: somebody expects something of them.
void check_parameters(Configuration& configuration, const std::string& source) {
  const Parameters& given = configuration.parameters();
  const auto unused = [&](const char* parameter, const std::string& expected) {
    configuration.parameter_fault(parameter,
                                  "goes with source " + expected + ", but the source is " + source);
  };
  if (source == "saved" && !given.given("lut"))
    configuration.parameter_fault("lut", "missing: source saved reads a LUT file");
  if (source != "saved" && given.given("lut")) unused("lut", "saved");
  const bool content = given.text("start") == "content";
  if (content && source != "charts" && source != "features") unused("start", "charts or features");
  if (source != "charts" && !content && given.given("charts")) unused("charts", "charts");
  if (source == "saved") check_blend(given, unused);
  if (!given.given("store")) return;
  if (source == "saved") return unused("store", kMadeHere);
  const std::string fault = store_fault(given.text("store"));
  if (!fault.empty()) configuration.parameter_fault("store", fault);
}

synthesis::BlendCurve curve_named(const std::string& name) {
  if (name == kLinear) return synthesis::BlendCurve::kLinear;
  return name == kBinary ? synthesis::BlendCurve::kBinary : synthesis::BlendCurve::kSmooth;
}

template <class T>
void take(Result<T> read, Configuration& configuration, T& into) {
  if (read) {
    into = std::move(*read);
  } else {
    configuration.faults(read.error());
  }
}

}  // namespace

std::vector<ParameterDescription> alignment_parameters() {
  return {
      choice(
          "source", "rig", {"rig", "nominal", "saved", "charts", "features"},
          "what the LUT is made from: the rig as it is, a stored LUT, charts on the ground or features of "
          "the overlaps; the latter two start from the rig, or on a simulated scene without one from poses "
          "as a measuring tape has them, which nominal takes as they are"),
      path("lut", "LUT file for source saved"),
      path("charts",
           "charts file, or a name in configs/charts, for source charts and start content; left out: the "
           "simulated scene's own"),
      choice(
          "start", "nominal", {"nominal", "content"},
          "where charts and features start from: the rig's poses, or what the pictures show of the charts"),
      path("store", "LUT file to write when the LUT has been made"),
      number("blend_deg", synthesis::BlendShape{}.width_deg, {0, 90}, "deg",
             "angle around the vehicle's corner over which two cameras blend; 0: a hard seam without "
             "statistics of overlaps; a stored LUT keeps its own"),
      choice("blend_shape", kSmooth, {kSmooth, kLinear, kBinary},
             "how the weights go over that angle; binary: every pixel shows one camera, and there are "
             "statistics all the same; a stored LUT keeps its own"),
  };
}

AlignmentSettings read_alignment_settings(Configuration& configuration) {
  const Parameters& given = configuration.parameters();
  AlignmentSettings settings;
  settings.source = given.text("source");
  settings.shape = {given.number("blend_deg"), curve_named(given.text("blend_shape"))};
  settings.store = given.text("store");
  check_parameters(configuration, settings.source);

  const bool nominal = settings.looks_at_frames() || settings.source == "nominal";
  auto rig = nominal ? nominal_rig_in_use(configuration) : rig_in_use(configuration);
  const bool rig_is_there = rig.has_value();
  take(std::move(rig), configuration, settings.rig);
  settings.view = view_in_use(configuration, settings.rig.vehicle);
  const std::string charts = given.text("charts");
  settings.from_content = settings.looks_at_frames() && given.text("start") == "content";
  if ((settings.source == "charts" || settings.from_content) && (rig_is_there || !charts.empty()))
    settings.charts = charts_in_use(configuration, charts);
  if (settings.source == "saved" && given.given("lut") && rig_is_there) {
    take(synthesis::read_lut_file(given.text("lut"), settings.rig, settings.view), configuration,
         settings.saved);
  }
  return settings;
}

}  // namespace svchain
