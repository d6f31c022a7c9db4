#include "algorithms/registration/joint_fit.h"

#include <Eigen/LU>
#include <random>

#include "algorithms/geometry/angles.h"
#include "algorithms/registration/consensus.h"
#include "algorithms/registration/overlap.h"
#include "tests/catch.h"
#include "tests/registration/perspectives.h"
#include "tests/scene/small_scene.h"

using namespace svchain;
using namespace svchain::registration;

namespace {

const Uncertainty kUncertainty = {geometry::radians(2), 0.03, 0.01};

Steps random_steps(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> within(-1, 1);
  Steps steps;
  for (auto& step : steps) {
    for (Eigen::Index i = 0; i < 6; ++i) step[i] = within(random) * kUncertainty.sigma()[i];
    step.tail<2>().setZero();
  }
  return steps;
}

Perspectives moved(const Perspectives& perspectives, const Steps& steps) {
  Perspectives result;
  for (size_t i = 0; i < 4; ++i) result[i] = stepped(perspectives[i], steps[i]);
  return result;
}

/// What the true cameras see of a grid in the corner between a and the next one.
std::vector<RayPair> seen_in_overlap(const Perspectives& truth, size_t a) {
  const double x = a == 0 || a == 3 ? 1 : -1, y = a >= 2 ? 1 : -1;
  std::vector<RayPair> pairs;
  for (double along = 2.6; along < 4.7; along += 0.4) {
    for (double across = 1.2; across < 3.3; across += 0.4) {
      const Eigen::Vector3d ground(x * along, y * across, 1);
      const size_t b = next_clockwise(a);
      pairs.push_back({a, b, truth[a] * ground, truth[b] * ground});
    }
  }
  return pairs;
}

std::vector<RayPair> seen_in_all_overlaps(const Perspectives& truth) {
  std::vector<RayPair> pairs;
  for (size_t a = 0; a < 4; ++a) {
    for (const auto& pair : seen_in_overlap(truth, a)) pairs.push_back(pair);
  }
  return pairs;
}

double worst_m(const Perspectives& starts, const Steps& steps, const std::vector<RayPair>& pairs) {
  const DisagreementMeter meter(starts, steps);
  double worst = 0;
  for (const auto& pair : pairs) worst = std::max(worst, meter.metres(pair).norm());
  return worst;
}

}  // namespace

TEST_CASE("a perspective matrix is the same map whatever its factor and sign") {
  const Eigen::Matrix3d matrix = testing::perspectives_of(testing::small_scene().rig)[0];
  for (const double factor : {1.0, -1.0, 1e-4, -300.0}) {
    const auto found = normalised(factor * matrix);
    REQUIRE(found);
    CHECK((*found - matrix).norm() < 1e-12);
  }
  CHECK_FALSE(normalised(Eigen::Matrix3d::Zero()));
  CHECK_FALSE(normalised(Eigen::Matrix3d::Constant(std::nan(""))));
}

TEST_CASE("disagreements change with the matrices as their derivatives say") {
  const Perspectives truth = testing::perspectives_of(testing::small_scene().rig);
  const Steps at = random_steps(1);
  const auto pair = seen_in_overlap(truth, 1)[7];
  const Disagreement d = DisagreementMeter(truth, at).measure(pair);
  Steps further = at;
  further[1] += 1e-4 * random_steps(2)[1];
  further[2] += 1e-4 * random_steps(2)[2];
  Eigen::Matrix<double, 16, 1> step;
  step << further[1] - at[1], further[2] - at[2];
  const Eigen::Vector2d change = DisagreementMeter(truth, further).metres(pair) - d.metres;
  CHECK((change - d.jacobian * step).norm() < 1e-3 * change.norm());
}

TEST_CASE("cameras that are degrees and centimetres off are fitted until what they see coincides") {
  const Perspectives truth = testing::perspectives_of(testing::small_scene().rig);
  const auto pairs = seen_in_all_overlaps(truth);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Perspectives starts = moved(truth, random_steps(seed));
    CHECK(worst_m(starts, testing::no_steps(), pairs) > 0.1);
    const JointFit fit = fit_jointly(starts, kUncertainty.sigma(), testing::no_steps(), pairs, 0.001);
    CHECK(worst_m(starts, fit.steps, pairs) < 0.002);
  }
}

TEST_CASE("false matches do not pull the fit") {
  const Perspectives truth = testing::perspectives_of(testing::small_scene().rig);
  const auto pairs = seen_in_all_overlaps(truth);
  auto spoilt = pairs;
  for (size_t i = 0; i < spoilt.size(); i += 5) spoilt[i].ray_b = spoilt[(i + 9) % spoilt.size()].ray_b;
  const Perspectives starts = moved(truth, random_steps(4));
  const JointFit fit = fit_jointly(starts, kUncertainty.sigma(), testing::no_steps(), spoilt, 0.01);
  CHECK(worst_m(starts, fit.steps, pairs) < 0.01);
}

TEST_CASE("without matches the matrices stay, and remain as uncertain as they were") {
  const Perspectives truth = testing::perspectives_of(testing::small_scene().rig);
  const JointFit fit = fit_jointly(truth, kUncertainty.sigma(), testing::no_steps(), {}, 0.01);
  for (const auto& step : fit.steps) CHECK(step.norm() == 0);
  CHECK(fit.covariance(0, 0) == Approx(std::pow(kUncertainty.rotation_rad, 2)));
  CHECK(fit.covariance(31, 31) == Approx(std::pow(kUncertainty.stretch, 2)));
}

TEST_CASE("one corner seen by two cameras makes both more certain") {
  const Perspectives truth = testing::perspectives_of(testing::small_scene().rig);
  const auto pairs = seen_in_overlap(truth, 0);
  const JointFit fit = fit_jointly(truth, kUncertainty.sigma(), testing::no_steps(), pairs, 0.01);
  const auto sigma = [&](int i) { return std::sqrt(fit.covariance(i, i)); };
  CHECK(sigma(0) < 0.9 * kUncertainty.rotation_rad);
  CHECK(sigma(8) < 0.9 * kUncertainty.rotation_rad);
  CHECK(sigma(16) == Approx(kUncertainty.rotation_rad));
}

TEST_CASE("of candidates that repeat like a chart those agree that one correction explains") {
  const Perspectives truth = testing::perspectives_of(testing::small_scene().rig);
  const Perspectives starts = moved(truth, random_steps(6));
  const auto pairs = seen_in_overlap(truth, 0);
  const DisagreementMeter meter(starts, testing::no_steps());
  std::vector<LinearPair> candidates;
  std::vector<bool> right;
  for (size_t i = 0; i < pairs.size(); ++i) {
    RayPair wrong = pairs[i];
    wrong.ray_b = pairs[(i + 7) % pairs.size()].ray_b;  // the like of a corner elsewhere on the chart
    candidates.push_back({i, meter.measure(wrong)});
    right.push_back(false);
    if (i % 3 == 0) continue;
    candidates.push_back({i, meter.measure(pairs[i])});
    right.push_back(true);
  }
  const PairCovariance prior = kUncertainty.sigma().cwiseAbs2().replicate<2, 1>().asDiagonal();
  const auto agreeing = consensus(candidates, prior, 0.02);
  CHECK(agreeing.size() >= 20);
  for (const size_t i : agreeing) CHECK(right[i]);
}

TEST_CASE("candidates that agree on nothing are no matches") {
  const Perspectives truth = testing::perspectives_of(testing::small_scene().rig);
  const auto pairs = seen_in_overlap(truth, 0);
  const DisagreementMeter meter(truth, testing::no_steps());
  std::vector<LinearPair> candidates;
  for (size_t i = 0; i < 8; ++i) {
    RayPair wrong = pairs[i];
    wrong.ray_b = pairs[(5 * i * i + 11) % pairs.size()].ray_b;
    candidates.push_back({i, meter.measure(wrong)});
  }
  const PairCovariance prior = kUncertainty.sigma().cwiseAbs2().replicate<2, 1>().asDiagonal();
  CHECK(consensus(candidates, prior, 0.01).empty());
}
