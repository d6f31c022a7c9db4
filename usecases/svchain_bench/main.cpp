// svchain_bench: a Google Benchmark program; with --ratios or --page it runs the side-by-side comparisons
// instead.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <benchmark/benchmark.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>

#include "usecases/svchain_bench/benchmarks.h"
#include "usecases/svchain_bench/comparisons.h"
#include "usecases/svchain_bench/free_cpus.h"
#include "usecases/svchain_bench/growth.h"
#include "usecases/svchain_bench/performance_page.h"
#include "usecases/svchain_page/machine.h"

namespace svchain::bench {

namespace {

namespace fs = std::filesystem;

void say(const std::string& what) {
  std::cerr << what << std::endl;
}

Results compare_all() {
  Results results;
  double least_cpus = cpus_for_two_threads();
  for (const auto compare : {compare_use_case, compare_synthesis, compare_bowl, compare_hops}) {
    compare(results, say);
    least_cpus = std::min(least_cpus, cpus_for_two_threads());
  }
  results.figures["machine.cpus_for_two_threads"] = least_cpus;
  return results;
}

/// Minutes later is too late for a bad name.
void require_writable(const fs::path& path) {
  if (!path.empty() && !std::ofstream(path, std::ios::app))
    throw std::runtime_error(path.string() + ": cannot be written");
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

void write_page(const fs::path& path, Results results) {
  Measured measured{std::move(results), measure_growth(say), this_machine(), these_versions(), page::today()};
  measured.results.figures["synthesis.pixel_cost_spread"] = spread(measured.growth.ns_per_pixel());
  for (const auto& [name, text] : performance_page(measured, path.stem().string()))
    write(path.parent_path() / name, text);
}

/// To a file of ratios, a page, or both.
void compare(const fs::path& ratios, const fs::path& page) {
  require_writable(ratios);
  require_writable(page);
  Results results = compare_all();
  if (!ratios.empty()) write(ratios, json_of(results, this_machine()).dump(2) + "\n");
  if (!page.empty()) write_page(page, std::move(results));
}

int run_benchmarks(std::vector<std::string> arguments) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  auto count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
  register_hop_benchmarks();
  register_surround_view_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace

}  // namespace svchain::bench

int main(int argc, char** argv) {
  CLI::App app("Measures hops, kernels and whole use cases beside other ways to do the same");
  std::filesystem::path ratios, page;
  app.add_option("--ratios", ratios, "a JSON file for the medians of paired ratios");
  app.add_option("--page", page, "a Markdown page for everything, with plots beside it: docs/performance.md")
      ->check([](const std::string& name) {
        return name.ends_with(".md") ? std::string() : name + ": a name ending in .md was expected";
      });
  app.allow_extras();
  app.footer(
      "Without --ratios and --page, options are Google Benchmark's: --benchmark_filter=REGEX, "
      "--benchmark_format=json, "
      "...");
  CLI11_PARSE(app, argc, argv);
  cv::setNumThreads(1);
  try {
    std::vector<std::string> arguments = app.remaining();
    arguments.insert(arguments.begin(), argv[0]);
    if (ratios.empty() && page.empty()) return svchain::bench::run_benchmarks(arguments);
    svchain::bench::compare(ratios, page);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
