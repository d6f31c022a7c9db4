#pragma once
// The joint refinement as a least squares problem for geometry::least_squares: which unknown is which column,
// residuals and their Jacobian. Borrows the problem; internal to joint_refinement.cpp.

#include <optional>
#include <vector>

#include "algorithms/calibration/joint_refinement.h"
#include "algorithms/calibration/lens_prior.h"

namespace svchain::calibration {

class JointModel {
 public:
  struct State {
    std::vector<UnknownCamera> cameras;
    std::vector<UnknownChart> charts;
  };

  explicit JointModel(const JointProblem& problem);

  Eigen::VectorXd residuals(const State& state) const;
  Eigen::MatrixXd jacobian(const State& state) const;
  State moved(State state, const Eigen::VectorXd& step) const;

  /// What it adds to the normal matrix to know that cameras do not shift or turn about the vertical on
  /// average.
  Eigen::MatrixXd held_in_place(const State& state) const;
  /// A camera's block of a matrix over all unknowns.
  Eigen::MatrixXd camera_block(const Eigen::MatrixXd& matrix, size_t camera) const;

 private:
  using FreeLenses = std::vector<std::optional<geometry::LensVariations>>;  // those that may change

  void add_sighting(const State& state, const FreeLenses& lenses, const CornerSighting& sighting,
                    Eigen::Ref<Eigen::MatrixXd> rows) const;
  Eigen::Index lens_unknowns(size_t camera) const;

  const JointProblem& problem_;
  Eigen::Index unknowns_ = 0;
  Eigen::Index rows_ = 0;
  std::vector<Eigen::Index> camera_at_, chart_at_;  // first columns
  std::vector<std::optional<LensPrior>> lens_priors_;
  std::vector<Eigen::Matrix2d> whitening_;  // of each sighting
};

}  // namespace svchain::calibration
