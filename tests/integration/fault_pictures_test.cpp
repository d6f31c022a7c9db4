// What faults of cameras leave in the picture, on a small view.

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/catch.h"
#include "tests/integration/faulty_run.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

using Json = nlohmann::json;

constexpr double kFps = 30, kBegins_s = 6, kEnds_s = 7, kAll_s = 7.5;
const cv::Size kView(220, 270);
/// What the camera on the left shows alone, and the one on the right; in between are those ahead and behind.
const cv::Rect kLeft(0, 115, 40, 40), kRight(180, 115, 40, 40);

struct Shown {
  Json report;
  std::vector<cv::Mat> pictures;  // as delivered
};

Shown show(const SurroundView& world, const Json& faults, double lasting_s, bool tone_mapping) {
  const TemporaryFolder folder;
  FaultyRun run;
  run.faults = faults;
  run.lasting_s = lasting_s;
  run.pixels = true;
  run.overrides = {"view.size_px=[220,270]", "output=" + (folder.path() / "pictures").string(),
                   std::string("photometric_alignment.enabled=") + (tone_mapping ? "true" : "false")};
  Shown shown{run_modelled(world, run), {}};
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder.path() / "pictures"))
    files.push_back(file.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) shown.pictures.push_back(cv::imread(file.string()));
  return shown;
}

Json fault_of_left(const char* kind) {
  return Json::array({{{"kind", kind}, {"at", "capture.left"}, {"from_s", kBegins_s}, {"to_s", kEnds_s}}});
}

bool is_same(const cv::Mat& a, const cv::Mat& b, const cv::Rect& part) {
  return cv::norm(a(part), b(part), cv::NORM_INF) == 0;
}

/// Pictures that were delivered a while after the fault began and before it ended.
std::pair<size_t, size_t> in_force(const Shown& shown) {
  const size_t until_end = static_cast<size_t>((kAll_s - kEnds_s) * kFps);
  const size_t end = shown.pictures.size() - until_end - 5;
  return {end - 20, end};
}

/// By how many levels the curves of two runs differ at most.
int largest_difference(const Json& a, const Json& b) {
  int largest = 0;
  for (const auto& [camera, channels] : a.items())
    for (const auto& [channel, curve] : channels.items())
      for (size_t v = 0; v < curve.size(); ++v)
        largest = std::max(largest, std::abs(curve[v].get<int>() - b[camera][channel][v].get<int>()));
  return largest;
}

}  // namespace

TEST_CASE("a camera that freezes shows its picture again, the others go on, and after it all four do") {
  const SurroundView world;
  const Shown shown = show(world, fault_of_left("freeze"), kAll_s, false);
  REQUIRE(shown.report["faults"]["list"][0]["times"] == 30);
  const auto [first, last] = in_force(shown);
  for (size_t i = first; i < last; ++i) {
    CHECK(is_same(shown.pictures[i], shown.pictures[first], kLeft));
    CHECK_FALSE(is_same(shown.pictures[i], shown.pictures[i + 1], kRight));
  }
  const auto& end = shown.pictures.back();
  CHECK_FALSE(is_same(end, shown.pictures[shown.pictures.size() - 2], kLeft));
}

TEST_CASE("a damaged picture shows where its camera looks, and nowhere else") {
  const SurroundView world;
  const Shown intact = show(world, Json::array(), kAll_s, false);
  const Shown shown = show(world, fault_of_left("corrupt"), kAll_s, false);
  REQUIRE(shown.pictures.size() == intact.pictures.size());
  cv::Mat damaged = cv::Mat::zeros(kView, CV_8UC1);
  for (size_t i = 0; i < shown.pictures.size(); ++i) {
    cv::Mat difference;
    cv::extractChannel(cv::abs(shown.pictures[i] - intact.pictures[i]), difference, 0);
    damaged |= difference;
  }
  CHECK(cv::countNonZero(damaged(kLeft)) > kLeft.area() / 2);
  CHECK(cv::countNonZero(damaged.colRange(kView.width / 2, kView.width)) == 0);
  CHECK(is_same(shown.pictures.back(), intact.pictures.back(), {{}, kView}));
}

TEST_CASE("one damaged picture moves no tone curve by more than three levels") {
  const SurroundView world;
  for (const double after_s : {0.1, 0.4}) {  // the report has the curves of the last view
    const Shown intact = show(world, Json::array(), kBegins_s + after_s, true);
    Json fault = fault_of_left("corrupt");
    fault[0]["to_s"] = kBegins_s + 1 / kFps - 0.001;
    const Shown shown = show(world, fault, kBegins_s + after_s, true);
    CHECK(shown.report["faults"]["list"][0]["times"] == 1);
    CHECK(largest_difference(intact.report["photometric"]["tone_mapping"],
                             shown.report["photometric"]["tone_mapping"]) <= 3);
  }
}
