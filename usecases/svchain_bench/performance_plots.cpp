#include "usecases/svchain_bench/performance_plots.h"

#include "usecases/svchain_bench/performance_table.h"
#include "usecases/svchain_page/bar_chart.h"
#include "usecases/svchain_page/line_plot.h"

namespace svchain::bench {

namespace {

page::Bar bar_of(const Subject& subject, const Paired& paired) {
  page::Bar bar{subject.name, paired.ratio, paired.quarter, paired.three_quarters, {}};
  if (subject.goal) {
    bar.goal = subject.goal->limit;
    bar.met = subject.goal->met(paired.ratio);
  }
  return bar;
}

}  // namespace

std::string ratio_plot(const Results& results) {
  page::BarGroup faster{"The other's cost over ours: more is better", {}};
  page::BarGroup dearer{"Our cost over the other's: less is better", {}};
  for (const Subject& subject : ratios_of(results, "")) {
    const auto found = results.ratios.find(subject.name);
    if (found == results.ratios.end()) continue;
    auto& group = is_ours_over_other(subject.name) ? dearer : faster;
    group.bars.push_back(bar_of(subject, found->second));
  }
  return page::bar_chart("Side by side with other ways to do the same", "ratio, medians of paired rounds",
                         {faster, dearer});
}

std::string size_plot(const Growth& growth) {
  page::Series all{"per pixel", {}}, shown{"per pixel in which a camera is seen", {}};
  for (const SizeCost& cost : growth.sizes) {
    const double megapixels = cost.pixels() * 1e-6;
    all.points.push_back({megapixels, cost.ns_per_pixel()});
    shown.points.push_back({megapixels, cost.ns_per_camera_pixel()});
  }
  return page::line_plot({"Synthesis against the size of the composite, one thread",
                          "composite, megapixels",
                          "cost, ns",
                          {shown, all}});
}

std::string links_plot(const Growth& growth) {
  page::Series one{"one core", {}}, two{"two cores in turn", {}}, tbb{"TBB flow graph, one thread", {}};
  for (const LineCost& cost : growth.lines) {
    const auto links = static_cast<double>(cost.links);
    one.points.push_back({links, cost.one_core_ns * 1e-3});
    two.points.push_back({links, cost.two_cores_ns * 1e-3});
    if (cost.tbb_ns) tbb.points.push_back({links, *cost.tbb_ns * 1e-3});
  }
  return page::line_plot({.title = "A frame through a line of links",
                          .x_axis = "links between source and sink",
                          .y_axis = "cost per frame, µs",
                          .series = {one, two, tbb},
                          .doubling_y = true});
}

}  // namespace svchain::bench
