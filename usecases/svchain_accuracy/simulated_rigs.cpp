#include <algorithm>
#include <functional>

#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/lens_like.h"

namespace svchain::accuracy {

namespace {

using Results = std::vector<SetResult>;
using FigureOf = std::function<double(const SetResult&)>;

constexpr const char* kProse =
    "Each set is four 1280x720 pictures of a scene drawn from a seed: a car (4.8 m) or a toy vehicle (0.48 "
    "m) "
    "with camera poses, lens centres and focal lengths of its own, four 5x4 checkerboards of 25 cm (toy: 2.5 "
    "cm) about its corners, boxes, posts and paint about, blurred by 0.5 px over a pixel's own area, "
    "exposures "
    "that differ by up to 1.8, noise of 2 grey levels. The calibration starts from poses that are off by up "
    "to "
    "5 cm (toy: 5 mm) along and 3 degrees about each axis. Lenses are fitted to the car's own "
    "(Kannala-Brandt) in each model; a pinhole cannot be like it and gets 144 degrees instead, which still "
    "shows the boards.\n\n"
    "The worst of four cameras counts. *Ground*: true places within 3 m of the vehicle (toy: 30 cm) that the "
    "true camera sees, 10 cm (1 cm) apart, through the true camera and back through the calibrated one, RMS. "
    "Limits on lengths are a tenth for the toy. *Sigmas*: the largest of a set's 24 errors in the sigmas "
    "that "
    "the calibration itself states; medians are over all sets, worst ones over those accepted. *Charts not "
    "posed*: the calibration is not told where the charts lie; errors after the best common motion of all "
    "cameras on the ground, sigmas before it.\n\n"
    "Baselines are given which corner is which and where to the nearest pixel. *Refined*: `cv::cornerSubPix` "
    "in the picture, then every camera's pose by Levenberg-Marquardt through the lens. *Homography*: the "
    "same "
    "corners undistorted to an ideal pinhole's picture, `cv::findHomography` to the ground; where it does "
    "not reach (80 degrees off the axis) it is not measured.\n";

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_of(const Results& results, const FigureOf& figure_of) {
  std::vector<double> values;
  for (const auto& result : results) values.push_back(figure_of(result));
  return median(values);
}

using OutcomeOf = Outcome SetResult::*;
using ErrorOf = double PoseError::*;

FigureOf figure_of(OutcomeOf outcome, ErrorOf error) {
  return [=](const SetResult& result) { return (result.*outcome).worst.*error; };
}

double worst_of(const Results& results, OutcomeOf outcome, ErrorOf error) {
  double worst = 0;
  for (const auto& result : results) {
    if ((result.*outcome).accepted) worst = std::max(worst, (result.*outcome).worst.*error);
  }
  return worst;
}

double worst_of(const Results& results, const FigureOf& figure_of) {
  double worst = 0;
  for (const auto& result : results) worst = std::max(worst, figure_of(result));
  return worst;
}

double accepted_percent(const Results& results, OutcomeOf outcome) {
  const auto accepted = std::count_if(results.begin(), results.end(),
                                      [&](const SetResult& result) { return (result.*outcome).accepted; });
  return 100.0 * static_cast<double>(accepted) / static_cast<double>(results.size());
}

struct PosedLimit {
  const char* name;
  ErrorOf error;
  double median, worst;  // of a car
  bool is_length;
};
const std::vector<PosedLimit> kPosedLimits = {
    {"rotation, degrees", &PoseError::rotation_deg, 0.015, 0.05, false},
    {"position, mm", &PoseError::translation_mm, 1, 3, true},
    {"ground, mm", &PoseError::ground_mm, 1.5, 5, true}};
constexpr double kUnposedGroundMm = 5, kMostSigmas = 5, kLeastAcceptedPercent = 95;

FigureOf homography_of(ErrorOf error) {
  return [error](const SetResult& result) {
    return error == &PoseError::ground_mm ? result.homography_ground_mm : std::nan("");
  };
}

/// A baseline that has no such figure shows none.
std::string or_none(double value) {
  return std::isnan(value) ? "-" : figure(value);
}

void add_posed(const Results& results, double scale, Table& table) {
  for (const auto& limit : kPosedLimits) {
    const FigureOf ours = figure_of(&SetResult::posed, limit.error);
    const FigureOf refined = [&](const SetResult& result) { return result.refined.*limit.error; };
    const FigureOf homography = homography_of(limit.error);
    const double factor = limit.is_length ? scale : 1;
    const double middle = median_of(results, ours);
    const double worst = worst_of(results, &SetResult::posed, limit.error);
    table.rows.push_back({std::string("charts posed: ") + limit.name + ", median", figure(middle),
                          figure(factor * limit.median), met(middle, factor * limit.median),
                          figure(median_of(results, refined)), or_none(median_of(results, homography))});
    table.rows.push_back(
        {std::string("charts posed: ") + limit.name + ", worst", figure(worst), figure(factor * limit.worst),
         met(worst, factor * limit.worst), figure(worst_of(results, refined)),
         limit.error == &PoseError::ground_mm ? figure(worst_of(results, homography)) : "-"});
  }
}

void add_rest(const Results& results, double scale, Table& table) {
  const auto add = [&](const std::string& name, double value, double limit) {
    table.rows.push_back({name, figure(value), figure(limit), met(value, limit), "-", "-"});
  };
  add("charts not posed: ground, mm, median",
      median_of(results, figure_of(&SetResult::unposed, &PoseError::ground_mm)), scale * kUnposedGroundMm);
  add("charts not posed: ground, mm, worst", worst_of(results, &SetResult::unposed, &PoseError::ground_mm),
      scale * kUnposedGroundMm);
  add("charts posed: sigmas, worst", worst_of(results, &SetResult::posed, &PoseError::sigmas), kMostSigmas);
  add("charts not posed: sigmas, worst", worst_of(results, &SetResult::unposed, &PoseError::sigmas),
      kMostSigmas);
  for (const auto& [name, outcome] : {std::pair("charts posed: accepted, %", &SetResult::posed),
                                      {"charts not posed: accepted, %", &SetResult::unposed}}) {
    const double percent = accepted_percent(results, outcome);
    table.rows.push_back({name, figure(percent), "at least " + figure(kLeastAcceptedPercent),
                          met(kLeastAcceptedPercent, percent), "-", "-"});
  }
}

Results of_vehicle(const Results& results, const std::string& vehicle) {
  Results some;
  for (const auto& result : results) {
    if (result.set.vehicle == vehicle) some.push_back(result);
  }
  return some;
}

Table summary(const Results& results, const std::string& vehicle) {
  Table table{{vehicle + ", " + std::to_string(results.size()) + " sets", "ours", "limit", "met", "refined",
               "homography"},
              {}};
  const double scale = vehicle == "toy" ? 0.1 : 1;
  add_posed(results, scale, table);
  add_rest(results, scale, table);
  return table;
}

/// Median and worst of the charts posed, and the worst with charts not posed.
Table by_lens(const Results& results, const std::string& vehicle) {
  Table table{{vehicle + ", lens", "sets", "accepted", "degrees", "mm", "ground mm", "sigmas",
               "ground mm, not posed", "sigmas, not posed"},
              {}};
  for (const auto& model : kLensModels) {
    Results some;
    for (const auto& result : results) {
      if (result.set.lens_model == model) some.push_back(result);
    }
    if (some.empty()) continue;
    const auto both = [&](ErrorOf error) {
      return figure(median_of(some, figure_of(&SetResult::posed, error))) + " / " +
             figure(worst_of(some, &SetResult::posed, error));
    };
    table.rows.push_back({model, std::to_string(some.size()),
                          figure(accepted_percent(some, &SetResult::posed)) + " / " +
                              figure(accepted_percent(some, &SetResult::unposed)) + " %",
                          both(&PoseError::rotation_deg), both(&PoseError::translation_mm),
                          both(&PoseError::ground_mm),
                          figure(worst_of(some, &SetResult::posed, &PoseError::sigmas)),
                          figure(worst_of(some, &SetResult::unposed, &PoseError::ground_mm)),
                          figure(worst_of(some, &SetResult::unposed, &PoseError::sigmas))});
  }
  return table;
}

/// What a reader has to know who wants to see a failure again.
std::string rejections(const Results& results) {
  std::string text;
  for (const auto& result : results) {
    for (const auto& [name, outcome] : {std::pair("posed", &result.posed), {"not posed", &result.unposed}}) {
      if (outcome->accepted) continue;
      text += "- Rejected: " + result.set.vehicle + ", " + result.set.lens_model + ", seed " +
              std::to_string(result.set.seed) + ", charts " + name + ": " + outcome->reasons + "\n";
    }
  }
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

Section simulated_rigs(const Results& results) {
  Section section{"Simulated rigs", kProse + rejections(results), {}};
  for (const std::string vehicle : {"car", "toy"}) {
    const Results some = of_vehicle(results, vehicle);
    if (some.empty()) continue;
    section.tables.push_back(summary(some, vehicle));
    section.tables.push_back(by_lens(some, vehicle));
  }
  return section;
}

}  // namespace svchain::accuracy
