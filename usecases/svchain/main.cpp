// The command line: which command, and what it is given.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <exception>
#include <functional>
#include <iostream>

#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"

namespace svchain::program {

namespace {

/// Called once everything has been parsed.
using Command = std::function<int()>;

void add_run_options(CLI::App& app, RunOptions& run) {
  UseCaseRequest& use_case = run.use_case;
  app.add_option("--usecase", use_case.use_case, "what to run: a name (svchain list usecases) or a file")
      ->type_name("NAME|FILE");
  app.add_option("--input", use_case.input,
                 "a folder with front, right, rear and left as stills, folders of numbered frames or videos; "
                 "simulated:SCENE; or front=URL,right=URL,rear=URL,left=URL")
      ->type_name("SOURCE");
  app.add_option("--output", use_case.output,
                 "a .png (last frame), .mp4, .mkv, a folder (numbered PNGs), window or none")
      ->type_name("PATH");
  app.add_option("--frames", run.frames,
                 "frames of each camera to take; all there are, stills 30, a simulated scene 300")
      ->type_name("N");
  app.add_option("--fps", run.fps, "in real time at this rate: what is late is dropped at the capture")
      ->type_name("F");
  app.add_option("--rig", use_case.rig, "where the cameras are and what their lenses do")->type_name("FILE");
  app.add_option("--soc", use_case.soc, "whose cores to run on: a name (svchain list socs) or a file")
      ->type_name("NAME|FILE");
  app.add_option("--costs", use_case.costs,
                 "with the virtual clock: figures that win over the SoC's, as svchain profile writes them")
      ->type_name("COSTS.json");
  app.add_option("--set", use_case.sets, "a parameter of a link, or view.KEY=VALUE (may be repeated)")
      ->type_name("LINK.PARAM=VALUE")
      ->allow_extra_args(false);
  app.add_option("--plugin", use_case.plugins, "a shared library with a link (may be repeated)")
      ->type_name("FILE.so")
      ->allow_extra_args(false);
  app.add_option("--report", run.report, "what every link, core, edge and pool did, as JSON; - is stdout")
      ->type_name("FILE");
  app.add_option("--trace", run.trace,
                 "every call and message with its time, for Perfetto and svchain timeline")
      ->type_name("FILE.json");
  app.add_option(
         "--control", run.control,
         "commands to links while running, a line each: LINK COMMAND [JSON]; a file, a named pipe, or "
         "- for stdin")
      ->type_name("FILE");
  app.add_option("--clock", run.clock,
                 "steady, or virtual: modelled time, as the SoC would take it, every run the same")
      ->type_name("CLOCK");
  app.add_flag("--no-pixels", run.no_pixels,
               "with the virtual clock: timing alone, thousands of times faster than real time");
  app.add_option("--faults", run.faults,
                 "what breaks in the run, where and when: a name (svchain list faults) or a file")
      ->type_name("NAME|FILE");
  app.add_option("--seed", run.seed,
                 "with the virtual clock: picks the order in which the cores take turns; with faults: what "
                 "chance decides of them (1)")
      ->type_name("N");
}

void add_list(CLI::App& app, Command& command) {
  auto* list_app = app.add_subcommand("list", "what there is: usecases, links, socs, lenses, faults");
  const auto what = std::make_shared<std::string>();
  list_app->add_option("WHAT", *what, "usecases, links, socs, lenses or faults; everything if left out");
  list_app->callback([what, &command] { command = [what] { return list(*what); }; });
}

void add_validate(CLI::App& app, Command& command) {
  auto* validate_app =
      app.add_subcommand("validate", "checks use cases, rigs, SoCs, costs, scenes, charts, paths and faults");
  const auto files = std::make_shared<std::vector<std::filesystem::path>>();
  validate_app->add_option("FILE", *files, "files to check")->required();
  validate_app->callback([files, &command] { command = [files] { return validate(*files); }; });
}

void add_graph(CLI::App& app, Command& command) {
  auto* graph_app = app.add_subcommand("graph", "draws a use case as it runs, IPC pairs included");
  const auto options = std::make_shared<GraphOptions>();
  graph_app->add_option("USECASE", options->use_case.use_case, "a name or a file")
      ->required()
      ->type_name("NAME|FILE");
  graph_app->add_option("--format", options->format, "dot, svg or json (dot)")->type_name("FORMAT");
  graph_app->add_option("--soc", options->use_case.soc, "on another SoC than its own")
      ->type_name("NAME|FILE");
  graph_app->add_option("--set", options->use_case.sets, "as for a run")
      ->type_name("LINK.PARAM=VALUE")
      ->allow_extra_args(false);
  graph_app->add_option("--plugin", options->use_case.plugins, "as for a run")
      ->type_name("FILE.so")
      ->allow_extra_args(false);
  graph_app->callback([options, &command] { command = [options] { return graph(*options); }; });
}

void add_explore(CLI::App& app, Command& command) {
  auto* explore_app = app.add_subcommand(
      "explore", "tries all placements of a use case's algorithms on all SoCs in modelled time, best first");
  const auto options = std::make_shared<ExploreOptions>();
  explore_app->add_option("USECASE", options->use_case.use_case, "a name or a file")
      ->required()
      ->type_name("NAME|FILE");
  explore_app->add_option("--fps", options->fps, "the rate to hold (30)")->type_name("F");
  explore_app->add_option("--output", options->output, "writes the best as a use case")
      ->type_name("BEST.json");
  explore_app->add_option("--soc", options->soc, "the only one to try; all that are shipped if left out")
      ->type_name("NAME|FILE");
  explore_app->add_option("--costs", options->use_case.costs, "as for a run")->type_name("COSTS.json");
  explore_app->add_option("--set", options->use_case.sets, "as for a run")
      ->type_name("LINK.PARAM=VALUE")
      ->allow_extra_args(false);
  explore_app->add_option("--plugin", options->use_case.plugins, "as for a run")
      ->type_name("FILE.so")
      ->allow_extra_args(false);
  explore_app->callback([options, &command] { command = [options] { return explore(*options); }; });
}

void add_profile(CLI::App& app, Command& command) {
  auto* profile_app = app.add_subcommand(
      "profile", "measures a use case's links here and writes what they cost on a SoC, relative to one link");
  const auto options = std::make_shared<ProfileOptions>();
  const auto add = [&](const char* name, auto& value, const char* type, const char* help) {
    return profile_app->add_option(name, value, help)->type_name(type);
  };
  UseCaseRequest& use_case = options->use_case;
  add("USECASE", use_case.use_case, "NAME|FILE", "a name or a file")->required();
  add("--output", options->output, "COSTS.json", "the file to write, for --costs or a SoC file")->required();
  add("--anchor", options->anchor, "LINK", "whose cycles the SoC is known to take (synthesis)");
  add("--soc", use_case.soc, "NAME|FILE", "as for a run");
  add("--rig", use_case.rig, "FILE", "as for a run");
  add("--input", use_case.input, "SOURCE", "as for a run, but no live one");
  add("--frames", options->frames, "N", "frames of each camera to take in each of 20 runs (12)");
  add("--set", use_case.sets, "LINK.PARAM=VALUE", "as for a run")->allow_extra_args(false);
  add("--plugin", use_case.plugins, "FILE.so", "as for a run")->allow_extra_args(false);
  profile_app->callback([options, &command] { command = [options] { return profile(*options); }; });
}

void add_schema(CLI::App& app, Command& command) {
  auto* schema_app = app.add_subcommand("schema", "the JSON Schema of a file format");
  const auto kind = std::make_shared<std::string>();
  schema_app
      ->add_option(
          "KIND", *kind,
          "usecase, rig, charts, corners, calibration, comparison, soc, costs, scene, path, faults or report")
      ->required();
  schema_app->callback([kind, &command] { command = [kind] { return schema(*kind); }; });
}

void add_import(CLI::App& app, Command& command) {
  auto* import_app = app.add_subcommand("import", "makes a rig file from other programs' calibrations");
  const auto options = std::make_shared<ImportOptions>();
  import_app
      ->add_option("FORMAT", options->format, "diy, lens_table_homography, kalibr, ros, woodscape or ocam")
      ->required();
  import_app
      ->add_option("FILES", options->files,
                   "each camera's file, told by its name; the lens table; a camchain")
      ->required();
  import_app
      ->add_option("--rig", options->rig,
                   "a nominal rig: the vehicle and the poses, for formats that have none (kalibr, ros, ocam)")
      ->type_name("NOMINAL.json");
  import_app->add_option("--output", options->output, "the rig file to write")
      ->required()
      ->type_name("RIG.json");
  const auto pixel = [&](const char* name, std::optional<std::vector<int>>& value, const char* help) {
    import_app->add_option(name, value, help)->type_name("X Y")->expected(2)->delimiter(',');
  };
  pixel("--canvas-size-px", options->canvas_size_px, "diy: width and height of the composite (1200 1600)");
  pixel("--car-min-px", options->car_min_px, "diy: the car's rectangle in it, upper left corner (500 550)");
  pixel("--car-max-px", options->car_max_px, "diy: lower right corner (700 1050)");
  import_app
      ->add_option("--canvas-metres-per-px", options->canvas_metres_per_px,
                   "diy: scale of the composite (0.01)")
      ->type_name("M");
  import_app->callback([options, &command] { command = [options] { return import_rig(*options); }; });
}

void add_export(CLI::App& app, Command& command) {
  auto* export_app = app.add_subcommand("export", "writes a rig's lenses for other programs");
  const auto options = std::make_shared<ExportOptions>();
  export_app->add_option("FORMAT", options->format, "kalibr or ros")->required();
  export_app->add_option("--rig", options->rig, "the rig file to read")->required()->type_name("RIG.json");
  export_app->add_option("--output", options->output, "the folder to write into")
      ->required()
      ->type_name("DIR");
  export_app->callback([options, &command] { command = [options] { return export_rig(*options); }; });
}

void add_simulate(CLI::App& app, Command& command) {
  auto* simulate_app =
      app.add_subcommand("simulate", "makes pictures of a simulated scene, with all that is true of them");
  const auto options = std::make_shared<SimulateOptions>();
  simulate_app->add_option("--scene", options->scene, "a name (parking, toy) or a file")
      ->type_name("NAME|FILE");
  simulate_app->add_option("--output", options->output, "the folder to make")->type_name("DIR");
  simulate_app->add_option("--frames", options->frames, "pictures of each camera (1)")->type_name("N");
  simulate_app
      ->add_option("--seed", options->seed,
                   "other noise, other ground, another nominal rig; 1 is the scene's own")
      ->type_name("N");
  simulate_app->callback([options, &command] { command = [options] { return simulate(*options); }; });
}

void add_calibrate(CLI::App& app, Command& command) {
  auto* calibrate_app = app.add_subcommand("calibrate", "makes a rig right by pictures of charts");
  const auto options = std::make_shared<CalibrateOptions>();
  const auto add = [&](const char* name, auto& value, const char* type, const char* help) {
    calibrate_app->add_option(name, value, help)->type_name(type);
  };
  add("--rig", options->rig, "NOMINAL.json", "the rig as far as it is known: poses good to a few degrees");
  add("--charts", options->charts, "CHARTS.json", "what lies on the ground");
  add("--images", options->images, "DIR", "a folder with front, right, rear and left");
  add("--corners", options->corners, "FILE.json", "corners clicked by hand; then --images may be left out");
  add("--output", options->output, "CALIBRATED.json", "the rig file to write");
  add("--report", options->report, "FILE.json", "how good it is, corner by corner, as JSON; - is stdout");
  add("--pictures", options->pictures, "DIR",
      "a folder to make: each camera's picture with its corners in it, and all four laid on the ground");
  add("--hold-out", options->hold_out, "WHICH",
      "even or odd: leaves these corners out of the fit and reports on them");
  add("--start", options->start, "HOW",
      "nominal (the rig's poses, which is usual) or content: from what the pictures show of the charts");
  calibrate_app->callback([options, &command] { command = [options] { return calibrate(*options); }; });
}

void add_compare(CLI::App& app, Command& command) {
  auto* compare_app = app.add_subcommand(
      "compare", "the composite without any alignment, with the geometric one, and with both, in figures");
  const auto options = std::make_shared<CompareOptions>();
  const auto add = [&](const char* name, auto& value, const char* type, const char* help) {
    return compare_app->add_option(name, value, help)->type_name(type);
  };
  UseCaseRequest& use_case = options->use_case;
  use_case.use_case = "2dsv_2dsp";
  add("--usecase", use_case.use_case, "NAME|FILE", "what to run (2dsv_2dsp)");
  add("--input", use_case.input, "SOURCE", "as for a run, but no live one");
  add("--rig", use_case.rig, "NOMINAL.json", "the rig as far as it is known");
  add("--align", options->align, "HOW",
      "charts, features, or a rig file that is calibrated already; charts where there are some, else "
      "features");
  add("--charts", options->charts, "FILE|NAME", "what lies on the ground; a simulated scene brings its own");
  add("--frames", options->frames, "N", "frames of each camera to take in each run (30)");
  add("--soc", use_case.soc, "NAME|FILE", "as for a run");
  add("--set", use_case.sets, "LINK.PARAM=VALUE", "as for a run")->allow_extra_args(false);
  add("--plugin", use_case.plugins, "FILE.so", "as for a run")->allow_extra_args(false);
  add("--output", use_case.output, "DIR",
      "the folder to make: none.png, geometric.png, both.png, figures.json");
  compare_app->callback([options, &command] { command = [options] { return compare(*options); }; });
}

void add_charts(CLI::App& app, Command& command) {
  auto* charts_app = app.add_subcommand("charts", "draws charts in true size, to be printed");
  const auto options = std::make_shared<ChartsOptions>();
  charts_app
      ->add_option("--charts", options->charts,
                   "a charts file; a checkerboard of 5 x 4 squares of 25 cm if left out")
      ->type_name("CHARTS.json");
  charts_app
      ->add_option(
          "--output", options->output,
          "a .pdf with a page for each chart; or a .png, where there are several charts one for each: "
          "charts.png becomes charts-NAME.png")
      ->required()
      ->type_name("FILE");
  charts_app->callback([options, &command] { command = [options] { return print_charts(*options); }; });
}

void add_timeline(CLI::App& app, Command& command) {
  auto* timeline_app = app.add_subcommand("timeline", "draws a trace: which core did what when");
  const auto options = std::make_shared<TimelineOptions>();
  timeline_app->add_option("TRACE.json", options->trace, "what a run with --trace has written")->required();
  timeline_app->add_option("--output", options->output, "the picture to write")
      ->required()
      ->type_name("FILE.svg");
  timeline_app->add_option("--from", options->from, "where to begin; a few frames where neither is given")
      ->type_name("MS");
  timeline_app->add_option("--to", options->to, "where to end")->type_name("MS");
  timeline_app->callback([options, &command] { command = [options] { return timeline(*options); }; });
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// What nobody has taken: unknown commands and options.
Faults unknown_words(const CLI::App& app) {
  Faults faults;
  const auto used = app.get_subcommands();
  const CLI::App& taker = used.empty() ? app : *used.front();
  const auto options = option_names(taker);
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  bool value_of_unknown = false;
  for (const std::string& word : app.remaining(true)) {
    if (word.starts_with("-") && word.size() > 1) {
      const std::string name = word.substr(0, word.find('='));
      faults.push_back({{},
                        {},
                        {},
                        "unknown option \"" + name + "\"" + did_you_mean(name, options) +
                            " (known: " + spoken_list(options) + ")"});
      value_of_unknown = name == word;
    } else if (!std::exchange(value_of_unknown, false)) {
      faults.push_back({{},
                        {},
                        {},
                        used.empty() ? "unknown command \"" + word + "\"" + did_you_mean(word, commands) +
                                           " (known: " + spoken_list(commands) + ", or --usecase ... to run)"
                                     : "unexpected \"" + word + "\""});
    }
  }
  return faults;
}

int obey(int argc, char** argv) {
  CLI::App app(
      "Links and chains for four-camera surround view.\n"
      "Without a command it runs a use case: svchain --usecase 2dsv_2dsp --output top_view.mp4",
      "svchain");
  app.allow_extras();
  RunOptions run_options;
  Command command = [&] { return run(run_options); };
  add_run_options(app, run_options);
  add_list(app, command);
  add_validate(app, command);
  add_graph(app, command);
  add_schema(app, command);
  add_import(app, command);
  add_export(app, command);
  add_simulate(app, command);
  add_calibrate(app, command);
  add_compare(app, command);
  add_charts(app, command);
  add_timeline(app, command);
  add_explore(app, command);
  add_profile(app, command);
  app.require_subcommand(0, 1);
  for (CLI::App* sub : app.get_subcommands({})) sub->allow_extras();

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    if (const Faults unknown = unknown_words(app); !unknown.empty()) return say(unknown);
    return say({{{}, {}, {}, error.what()}});
  }
  if (const Faults unknown = unknown_words(app); !unknown.empty()) return say(unknown);
  return command();
}

}  // namespace

}  // namespace svchain::program

int main(int argc, char** argv) {
  try {
    return svchain::program::obey(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "svchain: error: " << error.what() << '\n';
    return svchain::program::kFailed;
  }
}
