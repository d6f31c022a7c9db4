// The paper's comparison: one use case run three times, without any alignment, with the geometric one alone,
// and with the photometric one as well.

#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "algorithms/calibration/scene_charts.h"
#include "algorithms/colour/convert.h"
#include "links/capture/frame_source.h"
#include "links/image.h"
#include "links/surround_settings.h"
#include "usecases/svchain/chain_run.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/comparison.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/kept_inputs.h"
#include "usecases/svchain/new_folder.h"
#include "usecases/svchain/png_text.h"
#include "usecases/svchain/say_faults.h"

namespace svchain::program {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr uint64_t kFrames = 30;
constexpr const char *kCharts = "charts", *kFeatures = "features";

struct Variant {
  const char* name;
  bool aligned, photometric;
};
constexpr Variant kVariants[] = {{"none", false, false}, {"geometric", true, false}, {"both", true, true}};

/// A variant's chain, with what is to be looked at when it has run.
struct VariantRun {
  Variant variant = {};
  std::unique_ptr<Catalogue> catalogue;
  const KeptInputs* synthesis = nullptr;
  const KeptInputs* display = nullptr;
  std::unique_ptr<Chain> chain;
};

/// By what the frames show; else `align` is the file of a rig that is aligned already.
bool looks_at_frames(const std::string& align) {
  return align == kCharts || align == kFeatures;
}

Faults align_faults(const CompareOptions& options) {
  Faults faults;
  if (!options.align) return faults;
  const std::string& align = *options.align;
  const bool may_be_file = fs::exists(align) || fs::path(align).extension() == ".json";
  if (!looks_at_frames(align) && !may_be_file) {
    faults.push_back({"--align",
                      {},
                      {},
                      "expected charts, features or a rig file, got \"" + align + "\"" +
                          did_you_mean(align, {kCharts, kFeatures})});
  } else if (align != kCharts && options.charts) {
    faults.push_back({"--charts", {}, {}, "goes with --align charts, got --align " + align});
  }
  return faults;
}

/// As far as options and input say; by charts where there are some.
std::string align_of(const CompareOptions& options, const std::string& input) {
  if (options.align) return *options.align;
  if (options.charts) return kCharts;
  const auto scene = simulated_scene(input);
  return scene && *scene && !calibration::charts_of(**scene).empty() ? kCharts : kFeatures;
}

PlannedLink* link_of_type(Plan& plan, const std::string& type, Faults& faults) {
  for (PlannedLink& link : plan.links)
    if (link.entry.type == type) return &link;
  faults.push_back({plan.use_case.file,
                    {},
                    "/links",
                    "there is no link of type " + type + ", expected one: compare needs it"});
  return nullptr;
}

/// Parameters that tell the variants apart are not for --set.
Faults decided_faults(const LinkEntry& link, const std::vector<std::string>& decided) {
  Faults faults;
  for (const std::string& parameter : decided) {
    const auto origin = link.parameter_origins.find(parameter);
    if (origin == link.parameter_origins.end() || !origin->second.file.starts_with("--set")) continue;
    faults.push_back(origin->second.fault("compare decides on it itself, expected --align or --charts"));
  }
  return faults;
}

void put_alignment(Parameters& parameters, const std::string& source,
                   const std::optional<std::string>& charts) {
  parameters.put("source", source);
  parameters.put("lut", nullptr);
  parameters.put("store", nullptr);
  parameters.put("charts", charts ? Json(*charts) : Json());
  if (!looks_at_frames(source)) parameters.put("start", "nominal");
}

const KeptInputs* watch(PlannedLink& link) {
  auto kept = std::make_unique<KeptInputs>(std::move(link.link));
  const KeptInputs* watched = kept.get();
  link.link = std::move(kept);
  return watched;
}

/// Makes a plan the variant's.
void adapt(Plan& plan, const CompareOptions& options, VariantRun& run, Faults& faults) {
  PlannedLink* geometric = link_of_type(plan, "geometric_alignment", faults);
  PlannedLink* photometric = link_of_type(plan, "photometric_alignment", faults);
  PlannedLink* synthesis = link_of_type(plan, "synthesis", faults);
  PlannedLink* display = link_of_type(plan, "display", faults);
  if (!geometric || !photometric || !synthesis || !display) return;
  append(faults, decided_faults(geometric->entry, {"source", "lut", "store", "charts"}));
  append(faults, decided_faults(photometric->entry, {"enabled"}));

  const std::string align = align_of(options, setting_text(plan.use_case, "input"));
  const std::string source = !run.variant.aligned ? "nominal" : looks_at_frames(align) ? align : "rig";
  put_alignment(geometric->entry.parameters, source, source == kCharts ? options.charts : std::nullopt);
  photometric->entry.parameters.put("enabled", run.variant.photometric);
  run.synthesis = watch(*synthesis);
  run.display = watch(*display);
}

UseCaseRequest request_of(const CompareOptions& options, const Variant& variant) {
  UseCaseRequest request = options.use_case;
  request.output = "none";
  if (variant.aligned && options.align && !looks_at_frames(*options.align)) request.rig = *options.align;
  return request;
}

/// Its chain is configured, if there were no faults.
VariantRun prepared(const CompareOptions& options, const Variant& variant, const RunNumbers& numbers,
                    HostLoop& host, Faults& faults) {
  VariantRun run;
  run.variant = variant;
  auto planned = plan_use_case(request_of(options, variant));
  if (!planned) {
    append(faults, planned.error());
    return run;
  }
  const std::string input = setting_text(planned->plan.use_case, "input");
  if (is_live_source(input)) {
    faults.push_back({"--input", {}, {}, "is live and never the same again, expected files or a scene"});
    append(faults, rig_faults(planned->plan.use_case));
    return run;
  }
  adapt(planned->plan, options, run, faults);
  if (!run.display) return run;
  ChainOptions chain_options;
  chain_options.pace = pace_for(input, numbers, faults);
  chain_options.on_finished = [&host] { host.finish(); };
  run.catalogue = std::move(planned->catalogue);
  run.chain = std::make_unique<Chain>(std::move(planned->plan), std::move(chain_options));
  configure(*run.chain, faults);
  return run;
}

/// In BGR, whatever its format.
cv::Mat picture(const KeptInputs::Buffer& buffer, const std::string& what) {
  if (buffer.bytes.empty()) throw std::runtime_error("the last set has no frame of " + what);
  auto* bytes = const_cast<std::byte*>(buffer.bytes.data());
  cv::Mat bgr(buffer.format.height_px, buffer.format.width_px, CV_8UC3);
  colour::bgr_from(any_picture(buffer.format, bytes), colour::bgr_picture(bgr));
  return bgr;
}

LastComposite last_composite(const VariantRun& run) {
  const auto& frames = run.synthesis->last("frames");
  const auto& view = run.display->last("frames");
  const auto& lut = run.synthesis->last("lut");
  if (frames.size() != 4 || view.empty() || lut.empty()) throw std::runtime_error("no frame was delivered");
  LastComposite last;
  last.view = picture(view[0], "the composite");
  last.lut = lut[0].bytes;
  for (size_t c = 0; c < 4; ++c) last.frames[c] = picture(frames[c], geometry::kCameraNames[c]);
  const auto& curves = run.synthesis->last("tone_mapping");
  last.tone_mapping = synthesis::ToneMapping::identity();
  if (!curves.empty()) std::memcpy(&last.tone_mapping, curves[0].bytes.data(), sizeof last.tone_mapping);
  return last;
}

/// Features are looked for from where the aligned runs had the cameras to begin with.
geometry::Rig rig_for_features(const Chain& chain) {
  const UseCase& use_case = chain.plan().use_case;
  auto rig = nominal_rig_of(setting_text(use_case, "rig"), setting_text(use_case, "input"));
  if (!rig) throw std::runtime_error(rig.error().front().text());
  return std::move(*rig);
}

/// What figures.json says beside the figures of each variant.
Json heading_of(const CompareOptions& options, const Chain& chain) {
  const std::string input = setting_text(chain.plan().use_case, "input");
  const Json report = chain.report();
  return {{"usecase", report["usecase"]},
          {"input", input},
          {"align", align_of(options, input)},
          {"frames", report["frames"]["delivered"]},
          {"view", report["view"]}};
}

void write_comparison(const fs::path& path, const std::vector<LastComposite>& composites,
                      const Json& figures) {
  NewFolder folder(path);
  for (size_t i = 0; i < composites.size(); ++i)
    folder.write(std::string(kVariants[i].name) + ".png", png_text(composites[i].view));
  folder.write("figures.json", figures.dump(2) + "\n");
  folder.keep();
}

/// Tells what went wrong; kDone if nothing did.
int run_all(const std::vector<VariantRun>& runs, const RunNumbers& numbers, HostLoop& host) {
  for (const VariantRun& run : runs) {
    run_to_its_end(*run.chain, host, numbers, numbers.pace);
    if (host.interrupted()) return kInterrupted;
    const auto failure = run.chain->failure();
    if (!failure) continue;
    std::cerr << "svchain: error: " << run.variant.name << ": " << failure->text() << '\n';
    return kFailed;
  }
  return kDone;
}

}  // namespace

int compare(const CompareOptions& options) {
  prepare_libraries();
  Faults faults = NewFolder::check(options.use_case.output.value_or(""), "--output");
  append(faults, align_faults(options));
  RunNumbers numbers;
  numbers.pace.frames = read_whole_number("--frames", options.frames, {1, 1e12}, faults).value_or(kFrames);
  HostLoop host;
  std::vector<VariantRun> runs;
  for (const Variant& variant : kVariants) runs.push_back(prepared(options, variant, numbers, host, faults));
  if (!faults.empty()) return say(faults);
  if (const int status = run_all(runs, numbers, host); status != kDone) return status;

  std::vector<LastComposite> composites;
  composites.reserve(runs.size());
  for (const VariantRun& run : runs) composites.push_back(last_composite(run));
  const Chain& chain = *runs.back().chain;
  const SharedFeatures features = shared_features(rig_for_features(chain), composites.back().frames);
  Json figures = heading_of(options, chain);
  std::vector<NamedFigures> compared;
  for (size_t i = 0; i < composites.size(); ++i) {
    compared.push_back({kVariants[i].name, figures_of(composites[i], features)});
    figures["variants"][kVariants[i].name] = figures_json(compared.back().figures);
  }
  if (host.interrupted()) return kInterrupted;
  std::cerr << figures_table(compared);
  write_comparison(*options.use_case.output, composites, figures);
  std::cerr << *options.use_case.output << ": compared\n";
  return kDone;
}

}  // namespace svchain::program
