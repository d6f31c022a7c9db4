#pragma once
// Charts on paper, in true size. Pure functions, any thread.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "algorithms/calibration/charts.h"

namespace svchain::calibration {

/// A line of text: `place_m` is the left end of its base line.
struct Label {
  Eigen::Vector2d place_m = {0, 0};
  double height_m = 0;  // of the font
  std::string text;     // ASCII
};

/// White paper with a chart on it, metres from its lower left corner, x right and y up: as one looks at it
/// from above, and so does the chart's frame lie on it.
struct Sheet {
  std::string name;  // the chart's
  Eigen::Vector2d size_m = {0, 0};
  std::vector<std::vector<Eigen::Vector2d>> black;  // polygons that do not overlap
  std::vector<Label> labels;
};

/// The chart with half a side of white around; below that its name, its size and an arrow along x.
Sheet sheet_of(const Chart& chart);

/// What is printed where nobody says otherwise: 5 x 4 squares of 25 cm, on 1.5 m x 1.25 m and the labels.
Chart usual_chart();

/// A PDF file of a page for each sheet. Pages beyond the 14400 points that version 1.4 knows are told in
/// larger units (UserUnit, version 1.6).
std::string pdf_of(const std::vector<Sheet>& sheets);

/// A PNG file of two colours that says how many pixels a metre has: as many as keep its longer side below
/// 12000, at most 10000 (254 dpi). Edges are rounded to whole pixels.
std::string png_of(const Sheet& sheet);

}  // namespace svchain::calibration
