#include "tests/integration/surround_view.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "framework/chain/run.h"
#include "links/builtin_links.h"
#include "links/configs_folder.h"
#include "tests/integration/faulty_links.h"
#include "tests/scene/small_scene.h"

namespace svchain::testing {

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

template <class T>
T value_or_throw(Result<T> result) {
  if (result) return std::move(*result);
  std::string all;
  for (const Fault& fault : result.error()) all += fault.text() + "\n";
  throw std::runtime_error(all);
}

}  // namespace

SurroundView::SurroundView() {
  add_builtin_links(catalogue_);
  add_faulty_links(catalogue_);
  std::ofstream(folder_.path() / "rig.json") << geometry::rig_text(small_scene().rig);
  std::ofstream(folder_.path() / "scene.json") << R"({"rig":"rig.json","frame_rate_hz":30,"seed":3,
    "cameras":{"right":{"gain_bgr":[0.8,0.85,0.9]},"rear":{"gain_bgr":[1.2,1.15,1.1]}},
    "path":{"travel_m":1.5,"period_s":4,"turn_radius_m":20},
    "ground":{"metres_per_texel":0.02,"half_extent_m":8},
    "paint":[{"type":"line","points_m":[[-8,2.5],[8,2.5]],"width_m":0.2,"colour_bgr":[230,230,230]},
             {"type":"line","points_m":[[-8,-2.5],[8,-2.5]],"width_m":0.2,"colour_bgr":[60,200,230]}]})";
}

Plan SurroundView::plan(const std::string& use_case, const std::string& soc,
                        const std::vector<std::string>& overrides) const {
  const std::string text =
      use_case.starts_with("{") ? use_case : text_of(share_folder() / "usecases" / (use_case + ".json"));
  std::vector<Override> all = {{"input=simulated:" + (folder_.path() / "scene.json").string()},
                               {"view.size_px=[220,270]"},
                               {"display.sha256=true"}};
  for (const auto& o : overrides) all.push_back({o});
  auto read = value_or_throw(parse_use_case(text, "usecase.json", catalogue_, all));
  auto cores = value_or_throw(read_soc(configs_folder() / "socs" / (soc + ".json")));
  return value_or_throw(make_plan(std::move(read), std::move(cores), catalogue_));
}

nlohmann::json SurroundView::with_camera_fault(const std::string& use_case, const std::string& camera,
                                               const nlohmann::json& params) {
  auto text = nlohmann::json::parse(text_of(share_folder() / "usecases" / (use_case + ".json")));
  text["links"]["camera_fault"] = {{"type", "camera_fault"}, {"core", "IPU1"}, {"params", params}};
  for (auto& edge : text["edges"]) {
    if (edge == "capture." + camera + " -> sync." + camera)
      edge = "capture." + camera + " -> camera_fault.in";
  }
  text["edges"].push_back("camera_fault.out -> sync." + camera);
  return text;
}

nlohmann::json SurroundView::run(Plan plan, uint64_t frames, std::optional<uint64_t> seed) const {
  Chain chain(std::move(plan), by_hand_options(frames));
  if (auto configured = chain.configure(); !configured)
    throw std::runtime_error(configured.error().front().text());
  run_by_hand(chain, seed);
  auto report = chain.report();
  if (chain.failure()) report["failure"] = chain.failure()->text();
  return report;
}

ChainOptions by_hand_options(uint64_t frames) {
  ChainOptions options;
  options.execution = Execution::kByHand;
  options.pace.virtual_clock = true;
  options.pace.frames = frames;
  return options;
}

}  // namespace svchain::testing
