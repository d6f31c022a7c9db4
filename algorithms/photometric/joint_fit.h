#pragma once
// All cameras' tone curves and falloffs at once, from all overlaps (the paper's "Photometric alignment"): for
// each channel jointly, the squared differences between what two cameras show of a block, after correction,
// are minimised. The differences are relative ones, of the blocks' means, weighted by how far they may be
// believed and by Geman and McClure's function of how far they are off, so that what does not show the same
// thing counts for nothing. The trivial solution, everything equally dark or equally flat, is excluded: at
// every knot the sum of the cameras' logarithms stays what it was. Where the overlaps say nothing, curves are
// gains, and gains gammas of their own only as far as the data carry them: smoothness is in the sum of
// squares. Falloff is taken for none until the overlaps show it (Wald's test).
//
// Solved by Gauss and Newton's method. Allocates only when constructed; one thread.

#include <Eigen/Dense>
#include <vector>

#include "algorithms/photometric/evidence.h"
#include "algorithms/photometric/tone_curves.h"

namespace svchain::photometric {

class JointFit {
 public:
  JointFit(size_t cameras, size_t most_blocks, bool with_falloff);

  /// One step from `curves`, `rate` (above 0, at most 1) of the way. What the overlaps are found to determine
  /// is remembered, and forgotten at the same rate: where this frame says nothing, curves stay. Cameras
  /// without evidence stay as they are.
  void step(const Evidence& evidence, double rate, ToneCurves& curves);

  /// Blocks that the last step gave less than a quarter of their weight.
  size_t contradicting() const { return contradicting_; }

 private:
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  /// One channel's difference in one block, and how it changes with the state.
  struct Row {
    double difference = 0;
    int count = 0;
    std::array<int, 2 * (kKnots + 2)> index;
    std::array<double, 2 * (kKnots + 2)> derivative;

    void add(int at, double value) {
      index[count] = at;
      derivative[count++] = value;
    }
  };

  int knot_index(size_t camera, size_t channel, int knot) const;
  int falloff_index(size_t camera) const;

  void add_evidence(const Evidence& evidence, const ToneCurves& curves);
  void add_block(const SharedBlock& block, const ToneCurves& curves);
  Row row_of(const SharedBlock& block, const ToneCurves& curves, size_t channel) const;
  void remember(const Evidence& evidence, double rate);
  void expect(std::initializer_list<std::pair<int, double>> terms, double sigma);
  void add_expectations();
  void hold(const Evidence& evidence);
  void solve(double rate);

  size_t cameras_;
  int knots_;   // of all cameras and channels
  int length_;  // with falloffs
  bool with_falloff_;
  bool falloff_shown_ = false;
  double scale_ = 3;  // of the sigmas, as the last step found them; large at first, so that nothing is lost
  size_t contradicting_ = 0;
  Vector state_, gradient_, step_;  // the gradient points downhill
  Matrix curvature_, remembered_, system_;
  Eigen::LLT<Matrix> factor_;
  std::vector<double> distances_;  // of blocks, in sigmas
};

}  // namespace svchain::photometric
