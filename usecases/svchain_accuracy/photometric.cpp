#include <algorithm>
#include <chrono>

#include "algorithms/photometric/photometric_alignment.h"
#include "algorithms/synthesis/synthesize.h"
#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/photometric_figures.h"
#include "usecases/svchain_accuracy/photometric_sequences.h"
#include "usecases/svchain_accuracy/real_sets.h"

namespace svchain::accuracy {

namespace {

constexpr int kSeeds = 5;

/// The same methods over several sets.
struct Methods {
  std::vector<std::vector<PhotometricFigures>> sets;

  size_t count() const { return sets.front().size(); }
  const std::string& name(size_t method) const { return sets.front()[method].method; }
  template <class Of>
  double mean(size_t method, Of of) const {
    double sum = 0;
    for (const auto& set : sets) sum += of(set[method]);
    return sum / static_cast<double>(sets.size());
  }
  template <class Of>
  double largest(size_t method, Of of) const {
    double largest = 0;
    for (const auto& set : sets) largest = std::max(largest, of(set[method]));
    return largest;
  }
};

double left(const PhotometricFigures& figures) {
  return figures.left;
}

std::string with_limit(double value, double limit) {
  return figure(value) + " (" + figure(limit) + ", " + met(value, limit) + ")";
}

Table simulated_table(const ResponseRange& range, double left_limit, double ideal_limit) {
  Methods methods;
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
    methods.sets.push_back(PhotometricMeasurement(simulated_photometric_set(range, seed)).measure_all());
  Table table{{range.name, "left", "worst set", "from the ideal view", "contrast"}, {}};
  for (size_t m = 0; m < methods.count(); ++m) {
    const bool is_ours = m + 1 == methods.count();
    const double mean_left = methods.mean(m, left);
    const double from_ideal = methods.mean(m, [](const auto& f) { return *f.from_ideal; });
    table.rows.push_back({methods.name(m), is_ours ? with_limit(mean_left, left_limit) : figure(mean_left),
                          figure(methods.largest(m, left)),
                          is_ours ? with_limit(from_ideal, ideal_limit) : figure(from_ideal),
                          figure(methods.mean(m, [](const auto& f) { return f.contrast; }))});
  }
  return table;
}

PhotometricSet real_set(const std::string& name, const calibration::CalibrationInput& input,
                        const geometry::Rig& rig) {
  return {name, rig, photometric_view(rig.vehicle), input.pictures, {}};
}

Table real_table(const PhotometricSet& set) {
  const auto all = PhotometricMeasurement(set).measure_all();
  const PhotometricFigures& baseline = all[1];
  Table table{{set.name, "left", "of the baseline", "front-right", "right-rear", "rear-left", "left-front",
               "contrast"},
              {}};
  for (const PhotometricFigures& figures : all) {
    std::vector<std::string> row = {figures.method, figure(figures.left),
                                    figure(figures.left / baseline.left)};
    for (const double overlap : figures.overlaps) row.push_back(figure(overlap));
    row.push_back(figure(figures.contrast));
    table.rows.push_back(row);
  }
  return table;
}

void add_real(Result<calibration::CalibrationInput> input, const std::string& name,
              std::vector<Table>& tables) {
  if (!input) return;
  const auto calibrated = calibration::calibrate(*input);
  if (calibrated.accepted())
    tables.push_back(real_table(real_set(name + ", calibrated", *input, calibrated.rig)));
  tables.push_back(real_table(real_set(name + ", its author's rig", *input, input->nominal)));
}

/// Side by side: the median of the ratios.
double share_of_synthesis() {
  const PhotometricSet set = simulated_photometric_set(kUnlikeCameras, 1);
  const PhotometricMeasurement measurement(set);
  photometric::PhotometricAlignment alignment({.most_blocks = measurement.statistics().capacity});
  std::vector<double> ratios;
  const auto seconds = [](auto work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  for (int i = 0; i < 101; ++i) {
    const double update = seconds([&] { alignment.update(measurement.statistics()); });
    ratios.push_back(update / seconds([&] {
                       measurement.composite(synthesis::ToneMapping::identity(),
                                             synthesis::Kernel::kPortable);
                     }));
  }
  std::nth_element(ratios.begin(), ratios.begin() + 50, ratios.end());
  return ratios[50];
}

Table in_time() {
  const ExposureStep step = measure_exposure_step();
  Table table{{"in time", "measured", "limit", "met"}, {}};
  const auto add = [&](const std::string& what, double value, double limit) {
    table.rows.push_back({what, figure(value), figure(limit), met(value, limit)});
  };
  add("one camera 1.5 stops darker: frames until the overlaps differ by less than a level more than before",
      step.frames_to_settle, 15);
  add("and then the most that the composite's mean moves in a frame, grey levels", step.largest_move, 0.3);
  add("somebody crosses an overlap: the most that any entry of any curve moves", measure_crossing(), 2);
  add("equal cameras: the most that any entry of any curve is off the identity", measure_equal_cameras(), 1);
  add("time of photometric alignment as % of the portable kernel's synthesis", 100 * share_of_synthesis(), 4);
  return table;
}

}  // namespace

Section photometric(const std::filesystem::path& data) {
  Section section;
  section.title = "Brightness and colour";
  section.prose =
      "Photometric alignment (`algorithms/photometric`): what is left between two cameras on the 40x40 "
      "blocks of "
      "their overlap, mean of |a - b| over blocks and channels in grey levels, at equal mean of the "
      "composite. "
      "Blocks are halved like a checkerboard; each half is measured with what the other half tells. "
      "*Simulated*: "
      "means over " +
      std::to_string(kSeeds) +
      " sets of four cameras with responses drawn from a seed, noise of 2 grey levels; limits in brackets. "
      "All "
      "blocks count, also those that cameras clip; there, inverting a response gives something darker than "
      "it "
      "was, and ours what other cameras see. *From the ideal view*: mean difference of means over 21x21 px "
      "between the composite, "
      "after "
      "one curve per channel common to all cameras, and what one perfect camera above sees. *Contrast*: "
      "standard "
      "deviation over mean of the composite, relative to before. *Baseline*: gains from overlap means, their "
      "geometric mean as the anchor, then grey world. What is left in the real sets is gloss, which every "
      "camera "
      "sees elsewhere (garage), folds, and, with the authors' rigs, squares that do not lie on each other.";
  section.tables.push_back(simulated_table(kLikeCameras, 0.77, 3));
  section.tables.push_back(simulated_table(kUnlikeCameras, 2, 2));
  add_real(read_carpet(data), "real carpet", section.tables);
  add_real(read_garage(data), "real garage", section.tables);
  section.tables.push_back(in_time());
  return section;
}

}  // namespace svchain::accuracy
