// svchain_accuracy: measures calibrations and photometric alignment against truth that they have not seen and
// writes what comes out.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fstream>
#include <iostream>
#include <opencv2/core/utility.hpp>

#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/lens_like.h"
#include "usecases/svchain_page/machine.h"

namespace svchain::accuracy {

namespace {

struct Options {
  std::filesystem::path output = "docs/accuracy.md";
  std::filesystem::path data = "../shared/data";
  int sets = 3;
};

std::string heading(const Options& options) {
  return "# How accurate alignment is\n\n"
         "Geometry first, brightness and colour after it, all measured against truth that they have not "
         "seen. Written by one command, from the "
         "project's folder:\n\n"
         "```\nbuild/release/bin/svchain_accuracy --seeds " +
         std::to_string(options.sets) + " --data " + options.data.string() + " --output " +
         options.output.string() + "\n```\n\n" + page::today() + "; " + page::processor() + ", one core; " +
         page::compiler() + "; OpenCV " + page::opencv_version() +
         ". But for the times, every run gives the same figures.\n\n";
}

/// Written anew after every set, so that an interrupted run leaves what it has.
void write(const Options& options, const std::vector<Section>& sections) {
  std::ofstream file(options.output);
  file << heading(options);
  for (const auto& section : sections) file << markdown(section);
  if (!file.flush()) throw std::runtime_error(options.output.string() + ": cannot be written");
}

/// Every set of a vehicle has a seed of its own, so that no two have the same scene.
std::vector<SimulatedSet> simulated_sets(int per_lens_model) {
  std::vector<SimulatedSet> sets;
  uint64_t seed = 0;
  for (int i = 0; i < per_lens_model; ++i) {
    for (const auto& model : kLensModels) {
      ++seed;
      for (const std::string vehicle : {"car", "toy"}) sets.push_back({vehicle, model, seed});
    }
  }
  return sets;
}

void run(const Options& options) {
  std::vector<Section> sections = {{},
                                   rendered(options.data),
                                   real_carpet(options.data),
                                   real_garage(options.data),
                                   features(options.data),
                                   photometric(options.data),
                                   stage_times(options.data)};
  std::vector<SetResult> results;
  for (const auto& set : simulated_sets(options.sets)) {
    results.push_back(measure(set));
    std::cerr << text_of(results.back()) << std::endl;
    sections.front() = simulated_rigs(results);
    write(options, sections);
  }
}

}  // namespace

}  // namespace svchain::accuracy

int main(int argc, char** argv) {
  svchain::accuracy::Options options;
  CLI::App app("Measures calibrations and photometric alignment against truth that they have not seen");
  app.add_option("--output", options.output, "the page to write")->capture_default_str();
  app.add_option("--data", options.data, "the folder of the real recordings")->capture_default_str();
  app.add_option("--seeds", options.sets, "simulated sets per vehicle and lens model")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  cv::setNumThreads(1);
  try {
    svchain::accuracy::run(options);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
