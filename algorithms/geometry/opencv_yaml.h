#pragma once
// Matrices out of the YAML (or XML, JSON) files that OpenCV's FileStorage writes, hand-edited ones without
// the first line included. Not while other threads run OpenCV: its error printing is silenced for the time of
// reading.

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/json/fault.h"

namespace svchain::geometry {

struct WantedMatrix {
  std::string name;
  int rows;  // a row where a column is wanted will do, and the other way round
  int cols;
  bool required = true;
};

/// The matrices in the order of `wanted`, an absent optional one empty. All faults at once: missing names,
/// other sizes, numbers that are none.
Result<std::vector<Eigen::MatrixXd>> read_opencv_yaml(const std::filesystem::path& path,
                                                      const std::vector<WantedMatrix>& wanted);

}  // namespace svchain::geometry
