#include "algorithms/scene/scene_file.h"

#include <cmath>
#include <numbers>

#include "algorithms/json/value.h"
#include "algorithms/scene/paint_json.h"
#include "algorithms/scene/solids_json.h"

namespace svchain::scene {

namespace {

using json::Value;

const json::Range kLength{1e-4, 1e3};
constexpr int kMostTexels = 2000;  // from the origin to the ground's edge

Ground read_ground(const Value& value) {
  Ground ground;
  if (!value) return ground;
  value.only({"colour_bgr", "grain_contrast", "grain_m", "blotch_contrast", "blotch_m", "metres_per_texel",
              "half_extent_m"});
  ground.colour = read_colour(value.optional("colour_bgr"), ground.colour);
  ground.grain_contrast = value.optional("grain_contrast").number({0, 1}, ground.grain_contrast);
  ground.grain_m = value.optional("grain_m").number(kLength, ground.grain_m);
  ground.blotch_contrast = value.optional("blotch_contrast").number({0, 1}, ground.blotch_contrast);
  ground.blotch_m = value.optional("blotch_m").number(kLength, ground.blotch_m);
  ground.metres_per_texel = value.optional("metres_per_texel").number(kLength, 0);
  ground.half_extent_m = value.optional("half_extent_m").number(kLength, 0);
  if ((ground.metres_per_texel > 0) != (ground.half_extent_m > 0)) {
    value.fault("expected both or neither of \"metres_per_texel\" and \"half_extent_m\"");
  } else if (ground.half_extent_m > kMostTexels * ground.metres_per_texel) {
    value.optional("half_extent_m")
        .fault("expected at most " + std::to_string(kMostTexels) + " times \"metres_per_texel\"");
  }
  return ground;
}

Sky read_sky(const Value& value) {
  Sky sky;
  if (!value) return sky;
  value.only({"zenith_bgr", "horizon_bgr", "skyline_bgr", "skyline_deg"});
  sky.zenith = read_colour(value.optional("zenith_bgr"), sky.zenith);
  sky.horizon = read_colour(value.optional("horizon_bgr"), sky.horizon);
  sky.skyline = read_colour(value.optional("skyline_bgr"), sky.skyline);
  sky.skyline_deg = value.optional("skyline_deg").number({0, 60}, sky.skyline_deg);
  return sky;
}

Path read_path(const Value& value) {
  Path path;
  if (!value) return path;
  value.only({"travel_m", "period_s", "turn_radius_m"});
  path.travel_m = value.required("travel_m").number({0, 100}, path.travel_m);
  path.period_s = value.optional("period_s").number({0.1, 1e4}, path.period_s);
  path.turn_radius_m = value.optional("turn_radius_m").number({0.1, 1e6}, path.turn_radius_m);
  if (path.travel_m > path.turn_radius_m) {
    value.fault(
        "\"travel_m\" is more than \"turn_radius_m\": expected a turn of at most one radian to either side");
  }
  return path;
}

Response read_response(const Value& value) {
  Response response;
  if (!value) return response;
  value.only({"gain_bgr", "gamma", "falloff", "noise_sigma"});
  if (const auto gains = value.optional("gain_bgr")) {
    const auto numbers = gains.numbers(3, {0.01, 100});
    std::copy(numbers.begin(), numbers.end(), response.gain_bgr.begin());
  }
  response.gamma = value.optional("gamma").number({0.1, 10}, response.gamma);
  if (const auto falloff = value.optional("falloff")) {
    const auto numbers = falloff.numbers(2, {0, 10});
    std::copy(numbers.begin(), numbers.end(), response.falloff.begin());
  }
  response.noise_sigma = value.optional("noise_sigma").number({0, 100}, response.noise_sigma);
  return response;
}

NominalError read_nominal(const Value& value) {
  NominalError nominal;
  if (!value) return nominal;
  value.only({"position_m", "rotation_deg"});
  if (const auto position = value.optional("position_m")) nominal.position_m = position.number({0, 10, "m"});
  nominal.rotation_deg = value.optional("rotation_deg").number({0, 45, "degrees"}, nominal.rotation_deg);
  return nominal;
}

std::array<Response, 4> read_responses(const Value& cameras) {
  std::array<Response, 4> responses;
  if (!cameras) return responses;
  cameras.only(geometry::kCameraNames);
  for (size_t i = 0; i < responses.size(); ++i)
    responses[i] = read_response(cameras.optional(geometry::kCameraNames[i]));
  return responses;
}

std::vector<Checkerboard> read_charts(const Value& charts) {
  std::vector<Checkerboard> boards;
  for (const auto& chart : charts.items()) {
    chart.only({"name", "type", "squares", "square_m", "pose"});
    Checkerboard board;
    board.name = chart.required("name").string();
    chart.required("type").choice({"checkerboard"});
    const auto squares = chart.required("squares").items(2);
    for (size_t i = 0; i < squares.size(); ++i)
      board.squares[i] = static_cast<int>(squares[i].integer({2, 100}, 2));
    board.square_m = chart.required("square_m").number(kLength, 1);
    board.world_from_chart = read_pose(chart.required("pose"));
    for (const auto& other : boards) {
      if (other.name == board.name)
        chart.optional("name").fault("\"" + board.name + "\" is another chart's name already");
    }
    boards.push_back(std::move(board));
  }
  return boards;
}

geometry::Rig read_rig_of(const Value& name, Faults& faults) {
  const std::string file = name.string();
  if (file.empty()) {
    name.fault("expected the name of a rig file");
    return {};
  }
  auto rig = geometry::read_rig(name.document().folder() / file);
  if (rig) return *std::move(rig);
  name.fault("the rig \"" + file + "\" cannot be used");
  faults.insert(faults.end(), rig.error().begin(), rig.error().end());
  return {};
}

Result<Scene> from_document(const json::Document& document) {
  Faults faults;
  const Value root(document, faults);
  root.only({"rig", "ground", "paint", "charts", "boxes", "posts", "sky", "path", "cameras", "nominal",
             "frame_rate_hz", "timestamp_jitter_ms", "seed"});
  Scene scene;
  scene.rig = read_rig_of(root.required("rig"), faults);
  scene.ground = read_ground(root.optional("ground"));
  scene.paint = read_paint(root.optional("paint"));
  scene.charts = read_charts(root.optional("charts"));
  scene.boxes = read_boxes(root.optional("boxes"));
  scene.posts = read_posts(root.optional("posts"));
  scene.sky = read_sky(root.optional("sky"));
  scene.path = read_path(root.optional("path"));
  scene.responses = read_responses(root.optional("cameras"));
  scene.nominal = read_nominal(root.optional("nominal"));
  scene.frame_rate_hz = root.optional("frame_rate_hz").number({0.01, 1000}, scene.frame_rate_hz);
  const Value jitter = root.optional("timestamp_jitter_ms");
  scene.timestamp_jitter_ms = jitter.number({0, 1e5}, scene.timestamp_jitter_ms);
  if (2 * scene.timestamp_jitter_ms * scene.frame_rate_hz >= 1000) {
    jitter.fault("expected less than half the time between two frames, so that time stamps rise");
  }
  scene.seed = static_cast<uint64_t>(root.optional("seed").integer({0, 9e15}, 1));
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return scene;
}

}  // namespace

Result<Scene> read_scene(const std::filesystem::path& path) {
  return json::Document::read(path).and_then(from_document);
}

Result<Scene> parse_scene(const std::string& text, const std::string& file) {
  return json::Document::parse(text, file).and_then(from_document);
}

}  // namespace svchain::scene
