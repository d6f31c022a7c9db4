// svchain_bench: a Google Benchmark program; with --ratios it runs the side-by-side comparisons instead.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <benchmark/benchmark.h>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>

#include "usecases/svchain_bench/benchmarks.h"
#include "usecases/svchain_bench/comparisons.h"

namespace svchain::bench {

namespace {

Results compare_all() {
  Results results;
  const auto progress = [](const std::string& name) { std::cerr << name << std::endl; };
  compare_use_case(results, progress);
  compare_synthesis(results, progress);
  compare_hops(results, progress);
  return results;
}

void write_ratios(const std::string& path) {
  std::ofstream file(path);  // opened first: minutes later is too late for a bad name
  if (!file) throw std::runtime_error(path + ": cannot be written");
  file << json_of(compare_all(), this_machine()).dump(2) << '\n';
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
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
  std::string ratios;
  app.add_option("--ratios", ratios, "a JSON file for the medians of paired ratios");
  app.allow_extras();
  app.footer(
      "Without --ratios, options are Google Benchmark's: --benchmark_filter=REGEX, --benchmark_format=json, "
      "...");
  CLI11_PARSE(app, argc, argv);
  cv::setNumThreads(1);
  try {
    std::vector<std::string> arguments = app.remaining();
    arguments.insert(arguments.begin(), argv[0]);
    if (ratios.empty()) return svchain::bench::run_benchmarks(arguments);
    svchain::bench::write_ratios(ratios);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
