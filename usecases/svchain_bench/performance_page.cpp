#include "usecases/svchain_bench/performance_page.h"

#include "usecases/svchain_bench/performance_plots.h"
#include "usecases/svchain_bench/performance_table.h"

namespace svchain::bench {

namespace {

using page::figure;
using page::Section;
using page::Table;

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

std::string heading(const Measured& measured, const std::string& stem) {
  std::string text =
      "# How fast it is\n\n"
      "Ratios to other ways of doing the same, measured side by side in one process, turn and turn about. "
      "Written by one command, from the project's folder, on a machine that does nothing else:\n\n"
      "```\nbuild/release/bin/svchain_bench --page docs/" +
      stem + ".md\n```\n\n" + measured.date + "; " + measured.machine.processor + "; " +
      measured.machine.compiler;
  for (const auto& [name, version] : measured.versions)
    text.append("; ").append(name).append(" ").append(version);
  return text + ".\n\n";
}

Section summary(const Results& results, const std::string& stem) {
  const Tally tally = tally_of(results);
  const int met = tally.goals - static_cast<int>(tally.missed.size() + tally.not_measured.size());
  std::string prose = std::to_string(met) + " of " + std::to_string(tally.goals) + " goals are met.";
  if (!tally.missed.empty()) prose += " Missed: " + list(tally.missed) + ".";
  if (!tally.not_measured.empty()) prose += " Not measured here: " + list(tally.not_measured) + ".";
  return {"Summary",
          prose +
              "\n\nA ratio is the median over the rounds of the ratio within a round; half of the rounds lie "
              "between the quartiles beside it. It is the other's cost over ours, so more is better, but for "
              "`..._over_...`, which is ours over the least that there can be. Costs are medians, too.\n\n"
              "![Ratios as bars](" +
              stem + "_ratios.svg)\n",
          {}};
}

Section synthesis(const Results& results) {
  return {
      "Synthesis",
      "Four 1280x720 pictures of the simulated car park to 880x1080, with tone curves; "
      "ours keeps the statistics of the overlaps as well. *B*: for each camera its rectangle by "
      "`cv::remap` "
      "with fixed-point maps (CV_16SC2), `cv::LUT`, an integer blend. *A*: the same with float maps and a "
      "float blend. `.1t`: one thread each. `.2t`: two, which wait between frames: B by "
      "`cv::parallel_for_` in strips of rows, ours in parts of blocks as the link does it. `nv12`: frames "
      "in NV12, which B has to convert first. A round is a stream of 24 frames whose pictures come from "
      "memory, which is a chain's: in huge pages where the system allows them. All composites were within 2 "
      "levels of each other.\n",
      {ratio_table(results, "synthesis.", "ms")}};
}

Section chain(const Results& results) {
  return {"The use case",
          "`2dsv_2dsp` as the program runs it, without output, from frames in memory; costs are per frame. "
          "*Kernels in sequence*: synthesis and photometric alignment, called one after the other. *Program "
          "with B*: B over and over on one thread, without photometric alignment or anything else.\n",
          {ratio_table(results, "chain.", "ms")}};
}

Section hops(const Results& results) {
  return {
      "Hops",
      "One thread to another, 128 bytes a message. *rtt*: there and back; *spin_park*: 200 looks, then to "
      "sleep; *parked*: to sleep at once. *stream*: one way, as fast as they go. Ours are whole chains "
      "with pools, accounts and statistics; `ipc` is rings and doorbells alone. *Ring*: one producer, one "
      "consumer, nothing around it. The flow graph has no bound on what waits, and its scheduler decides "
      "which of two threads works. GStreamer is `appsrc ! queue ! appsink` with room for 64 buffers, made "
      "beforehand; what arrives is taken on the queue's own thread.\n",
      {ratio_table(results, "hop.", "ns")}};
}

Section figures(const Results& results) {
  return {
      "Figures",
      "From capture to display: the 99th percentile at 30 frames/s, ms. On one core: what one link more "
      "costs a frame, ns. Cost per pixel: the largest over the smallest as the composite grows, all pixels "
      "counted. The bowl: frames/s of `3dsv` (on an orbit, standing, with NV12); what the stages of a frame "
      "on the orbit take, ms, each waited for, as no run does; frames/s of `3dsv_cpu` on two "
      "CPUs on an orbit, the car included; a standing viewpoint's frame over the 2D view's, one thread "
      "each; and what a viewpoint's LUT, the car's picture and a mesh table take on one thread. The last "
      "line is about the machine: how many CPUs two busy threads got, the "
      "least of several looks between the comparisons. Well below 2 it did other things meanwhile, and "
      "what is said of two threads means little.\n",
      {figure_table(results)}};
}

Table size_table(const Growth& growth) {
  Table table{{"composite, px", "seen by a camera", "ms", "ns per pixel", "ns per pixel seen"}, {}};
  for (const SizeCost& cost : growth.sizes)
    table.rows.push_back({std::to_string(cost.width_px) + "x" + std::to_string(cost.height_px),
                          figure(100 * cost.camera_pixels / cost.pixels()) + " %", figure(cost.ms),
                          figure(cost.ns_per_pixel()), figure(cost.ns_per_camera_pixel())});
  if (growth.sizes.empty()) return table;
  const double all = spread(growth.ns_per_pixel()), seen = spread(growth.ns_per_camera_pixel());
  table.rows.push_back({"**largest over smallest**", "", "", figure(all), figure(seen)});
  table.rows.push_back(
      {kPixelCostGoal.text(), "", "", verdict(kPixelCostGoal, all), verdict(kPixelCostGoal, seen)});
  return table;
}

Table link_table(const Growth& growth) {
  Table table{{"links", "one core, ns", "a hop", "two cores, ns", "a hop", "TBB flow graph, ns", "a hop"},
              {}};
  for (const LineCost& cost : growth.lines) {
    std::vector<std::string> row = {std::to_string(cost.links)};
    const auto add = [&](const std::optional<double>& ns) {
      row.push_back(ns ? figure(*ns) : "not installed");
      row.push_back(ns ? figure(*ns / (cost.links + 1)) : "");
    };
    add(cost.one_core_ns);
    add(cost.two_cores_ns);
    add(cost.tbb_ns);
    table.rows.push_back(row);
  }
  return table;
}

Table camera_table(const Growth& growth) {
  Table table{{"cameras", "a hop on one core, ns", "a hop to another core, ns", "synthesis, ms"}, {}};
  for (const CameraCost& cost : growth.cameras)
    table.rows.push_back({std::to_string(cost.cameras), figure(cost.one_core_hop_ns),
                          figure(cost.two_cores_hop_ns),
                          cost.synthesis_ms ? figure(*cost.synthesis_ms) : ""});
  return table;
}

Section size_section(const Growth& growth, const std::string& stem) {
  return {
      "As the composite grows",
      "Synthesis on one thread with the fastest kernel, frames from memory, as they arrive from cameras. "
      "Every composite shows the ground at the same number of metres per pixel, so a larger one sees "
      "farther: its outer parts are far away, where neighbours read the same pixels of a camera, while "
      "the smallest hardly leaves the vehicle. Cost is given per pixel of the composite, and per pixel in "
      "which a camera is seen (the vehicle's silhouette and black are none).\n\n![Cost against size](" +
          stem + "_size.svg)\n",
      {size_table(growth)}};
}

Section link_section(const Growth& growth, const std::string& stem) {
  return {"As the chain grows",
          "A source, links that hand frames on, a sink: cost per frame, and per hop, of which there is one "
          "more than links. On two cores every hop crosses to the other core, and both work at once. TBB's "
          "are as many lightweight nodes, which on one thread call each other at once; they copy the message "
          "and keep no account of it.\n\n![Cost against links](" +
              stem + "_links.svg)\n",
          {link_table(growth)}};
}

Section camera_section(const Growth& growth) {
  return {
      "As cameras are added",
      "What one link more costs a frame that is a set of so many cameras' pictures, each with a buffer, a "
      "reference and an account of its own; both cores at once where there are two. Synthesis of "
      "880x1080 px on one thread with the fastest kernel, frames from memory: rigs have four cameras, and "
      "what it costs goes by the composite's pixels, whoever has seen them.\n",
      {camera_table(growth)}};
}

}  // namespace

Files performance_page(const Measured& measured, const std::string& stem) {
  const Results& results = measured.results;
  std::string text = heading(measured, stem);
  const Growth& growth = measured.growth;
  for (const Section& section :
       {summary(results, stem), synthesis(results), chain(results), hops(results), figures(results),
        size_section(growth, stem), link_section(growth, stem), camera_section(growth)})
    text += markdown(section);
  return {{stem + ".md", text},
          {stem + "_ratios.svg", ratio_plot(results)},
          {stem + "_size.svg", size_plot(growth)},
          {stem + "_links.svg", links_plot(growth)}};
}

}  // namespace svchain::bench
