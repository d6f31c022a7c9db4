#pragma once
// The program's commands, a file for each. They return the exit status; results go to stdout, everything else
// to stderr.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "usecases/svchain/plan_use_case.h"

namespace svchain::program {

/// Numbers as they were typed: bad ones are faults beside all others.
struct RunOptions {
  UseCaseRequest use_case;
  std::optional<std::string> frames, fps, seed;
  std::string clock = "steady";
  bool no_pixels = false;
  std::optional<std::string> faults;   // NAME or FILE
  std::optional<std::string> report;   // a file, or "-" for stdout
  std::optional<std::string> trace;    // a file
  std::optional<std::string> control;  // a file or pipe, or "-" for stdin
};
int run(const RunOptions& options);

/// "usecases", "links", "socs", "lenses", "faults", or "" for all of them.
int list(const std::string& what);

int validate(const std::vector<std::filesystem::path>& files);

struct GraphOptions {
  UseCaseRequest use_case;
  std::string format = "dot";
};
int graph(const GraphOptions& options);

struct ExploreOptions {
  UseCaseRequest use_case;
  std::optional<std::string> fps;
  std::optional<std::string> output;  // the best placement, as a use case
  std::optional<std::string> soc;     // NAME or FILE, the only one to try
};
int explore(const ExploreOptions& options);

struct ProfileOptions {
  UseCaseRequest use_case;
  std::optional<std::string> frames;  // of each run
  std::string anchor = "synthesis";   // a link, or a type of link
  std::string output;                 // the costs file to write
};
int profile(const ProfileOptions& options);

int schema(const std::string& kind);

struct ImportOptions {
  std::string format;
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> rig;  // nominal: vehicle and poses for formats that have none
  std::filesystem::path output;
  // The composite that the files of "diy" lead to; what is not given is as that project has it.
  std::optional<std::vector<int>> canvas_size_px, car_min_px, car_max_px;
  std::optional<double> canvas_metres_per_px;
};
int import_rig(const ImportOptions& options);

struct ExportOptions {
  std::string format;
  std::filesystem::path rig;
  std::filesystem::path output;  // a folder
};
int export_rig(const ExportOptions& options);

/// Numbers as they were typed.
struct SimulateOptions {
  std::string scene;  // NAME or FILE
  std::filesystem::path output;
  std::optional<std::string> frames, seed;
};
int simulate(const SimulateOptions& options);

/// What is missing is told beside all other faults.
struct CalibrateOptions {
  std::optional<std::filesystem::path> rig, charts;
  std::optional<std::filesystem::path> images, corners;  // either or both
  std::optional<std::filesystem::path> output;
  std::optional<std::string> report;  // a file, or "-" for stdout
  std::optional<std::filesystem::path> pictures;
  std::optional<std::string> hold_out;
  std::optional<std::string> start;
};
int calibrate(const CalibrateOptions& options);

/// The output is a folder, and a fault where it is left out.
struct CompareOptions {
  UseCaseRequest use_case;
  std::optional<std::string> frames;
  std::optional<std::string> align;   // "charts", "features" or a rig file
  std::optional<std::string> charts;  // NAME or FILE
};
int compare(const CompareOptions& options);

/// Milliseconds as they were typed.
struct TimelineOptions {
  std::filesystem::path trace;
  std::filesystem::path output;
  std::optional<std::string> from, to;
};
int timeline(const TimelineOptions& options);

struct ChartsOptions {
  std::optional<std::filesystem::path> charts;  // left out: the usual chart
  std::filesystem::path output;                 // .pdf or .png
};
int print_charts(const ChartsOptions& options);

}  // namespace svchain::program
