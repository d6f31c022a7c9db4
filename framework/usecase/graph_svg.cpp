#include <algorithm>
#include <cmath>
#include <sstream>

#include "framework/usecase/entries.h"
#include "framework/usecase/graph_layout.h"
#include "framework/usecase/palette.h"
#include "framework/usecase/svg_text.h"

namespace svchain {

namespace {

constexpr double kPillHeight = 15;
const std::string kEdgeColour = "#5b6470";
const std::string kFeedbackColour = "#c0392b";

/// Tenths of a pixel are enough, and keep the file readable.
std::string at(double v) {
  std::ostringstream out;
  out << std::round(v * 10) / 10;
  return out.str();
}

class Svg {
 public:
  Svg(const Plan& plan, const Layout& layout) : plan_(plan), layout_(layout) {}

  std::string run() {
    const std::string width = at(layout_.width), height = at(layout_.height);
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
         << "\" viewBox=\"0 0 " << width << " " << height
         << "\" font-family=\"Helvetica, Arial, sans-serif\">\n"
         << "<defs>";
    marker("arrow", kEdgeColour);
    marker("arrow_feedback", kFeedbackColour);
    out_ << "</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    title();
    for (size_t i = 0; i < plan_.cores.size(); ++i) lane(i);
    for (size_t i = 0; i < plan_.edges.size(); ++i) edge(i);
    for (size_t i = 0; i < plan_.links.size(); ++i) box(i);
    for (size_t i = 0; i < plan_.edges.size(); ++i) pills(i);
    legend();
    out_ << "</svg>\n";
    return out_.str();
  }

 private:
  void marker(const std::string& id, const std::string& colour) {
    out_ << "<marker id=\"" << id
         << "\" viewBox=\"0 0 8 8\" refX=\"7.2\" refY=\"4\" markerWidth=\"8\" markerHeight=\"8\" "
         << "markerUnits=\"userSpaceOnUse\" orient=\"auto\"><path d=\"M0,0.6 L8,4 L0,7.4 z\" fill=\""
         << colour << "\"/></marker>";
  }

  void text(double x, double y, int size, const std::string& colour, const std::string& anchor,
            const std::string& what, bool bold = false) {
    out_ << "<text x=\"" << at(x) << "\" y=\"" << at(y) << "\" font-size=\"" << size << "\" fill=\"" << colour
         << "\" text-anchor=\"" << anchor << "\"" << (bold ? " font-weight=\"bold\"" : "") << ">"
         << svg_text(what) << "</text>\n";
  }

  void rectangle(double x, double y, double width, double height, double radius, const std::string& fill,
                 const std::string& stroke) {
    out_ << "<rect x=\"" << at(x) << "\" y=\"" << at(y) << "\" width=\"" << at(width) << "\" height=\""
         << at(height) << "\" rx=\"" << at(radius) << "\" fill=\"" << fill << "\" stroke=\"" << stroke
         << "\"/>\n";
  }

  void title() {
    const UseCase& use_case = plan_.use_case;
    const bool titled = !use_case.title.empty();
    text(kMargin, kMargin + 20, 20, "#222b36", "start", titled ? use_case.title : use_case.name, true);
    text(kMargin, kMargin + 40, 12, "#6a7480", "start",
         (titled ? use_case.name + " on " : "on ") + plan_.soc.title + ", " +
             std::to_string(plan_.links.size()) + " links on " + std::to_string(plan_.cores.size()) +
             (plan_.cores.size() == 1 ? " core" : " cores"));
  }

  void lane(size_t i) {
    const LaneSpot& spot = layout_.lanes[i];
    const SocCore& core = plan_.cores[i];
    const Colour& colour = colour_of_core(static_cast<int>(i));
    const double middle = spot.y + spot.height / 2;
    rectangle(kMargin, spot.y, layout_.width - 2 * kMargin, spot.height, 8, colour.lane, "none");
    rectangle(kMargin, spot.y, 6, spot.height, 3, colour.edge, "none");
    text(kMargin + 18, middle - 4, 15, colour.edge, "start", core.name, true);
    text(kMargin + 18, middle + 12, 10, "#6a7480", "start",
         core.kind + (core.count > 1 ? " x" + std::to_string(core.count) : ""));
    if (core.clock_mhz > 0)
      text(kMargin + 18, middle + 25, 10, "#6a7480", "start", at(core.clock_mhz) + " MHz");
  }

  void box(size_t i) {
    const BoxSpot& spot = layout_.boxes[i];
    const PlannedLink& link = plan_.links[i];
    const Colour& colour = colour_of_core(link.core);
    rectangle(spot.x, spot.y, spot.width, spot.height, 9, colour.box, colour.edge);
    const bool typed = link.entry.type != link.entry.name;
    text(spot.x + spot.width / 2, spot.y + (typed ? 17 : 23), 13, "#222b36", "middle", link.entry.name, true);
    if (typed) text(spot.x + spot.width / 2, spot.y + 31, 10, "#4c5661", "middle", link.entry.type);
    for (const PortSpot& port : spot.inputs)
      text(spot.x + 9, port.y + 3.5, 10, "#4c5661", "start", port.name);
    for (const PortSpot& port : spot.outputs)
      text(spot.x + spot.width - 9, port.y + 3.5, 10, "#4c5661", "end", port.name);
  }

  /// Smooth where it changes height, straight where it passes a column.
  static std::string path_of(const WaySpot& way) {
    std::string path = "M" + at(way.points.front().x) + "," + at(way.points.front().y);
    for (size_t i = 1; i < way.points.size(); ++i) {
      const WayPoint& a = way.points[i - 1];
      const WayPoint& b = way.points[i];
      const double reach = a.direction == b.direction ? std::max(28.0, std::abs(b.x - a.x) / 2) : 46.0;
      path += " C" + at(a.x + reach * a.direction) + "," + at(a.y) + " " + at(b.x - reach * b.direction) +
              "," + at(b.y) + " " + at(b.x) + "," + at(b.y);
    }
    return path;
  }

  void edge(size_t i) {
    const PlannedEdge& edge = plan_.edges[i];
    const bool feedback = edge.entry.feedback;
    out_ << "<path d=\"" << path_of(layout_.ways[i]) << "\" fill=\"none\" stroke=\""
         << (feedback ? kFeedbackColour : kEdgeColour) << "\" stroke-width=\"" << (edge.ipc ? "2.6" : "1.4")
         << "\"" << (feedback ? " stroke-dasharray=\"7 4\"" : "")
         << (edge.ipc   ? ""
             : feedback ? " marker-end=\"url(#arrow_feedback)\""
                        : " marker-end=\"url(#arrow)\"")
         << "><title>" << svg_text(edge.entry.name()) << ", depth " << edge.entry.depth << ", "
         << kPolicyNames[static_cast<size_t>(edge.entry.policy)] << "</title></path>\n";
  }

  /// An IPC end stands on the core of the link it belongs to.
  void pill(double x, double y, int core, const std::string& what, bool feedback) {
    const Colour& colour = colour_of_core(core);
    rectangle(x, y - kPillHeight / 2, kPillWidth, kPillHeight, kPillHeight / 2, "#ffffff",
              feedback ? kFeedbackColour : colour.edge);
    text(x + kPillWidth / 2, y + 3, 9, feedback ? kFeedbackColour : colour.edge, "middle", what, true);
  }

  void pills(size_t i) {
    const PlannedEdge& edge = plan_.edges[i];
    if (!edge.ipc) return;
    const bool feedback = edge.entry.feedback;
    const WayPoint& from = layout_.ways[i].points.front();
    const WayPoint& to = layout_.ways[i].points.back();
    pill(from.x - kPillWidth, from.y, plan_.links[static_cast<size_t>(edge.from_link)].core, "IPC out",
         feedback);
    pill(to.x, to.y, plan_.links[static_cast<size_t>(edge.to_link)].core, "IPC in", feedback);
  }

  void legend_line(double x, const std::string& what, const std::string& colour, const std::string& style) {
    const double y = layout_.height - kLegendHeight / 2;
    out_ << "<path d=\"M" << at(x) << "," << at(y) << " h34\" stroke=\"" << colour << "\" " << style
         << "/>\n";
    text(x + 42, y + 3.5, 10, "#6a7480", "start", what);
  }

  void legend() {
    legend_line(kMargin, "within a core", kEdgeColour, "stroke-width=\"1.4\" marker-end=\"url(#arrow)\"");
    legend_line(kMargin + 150, "between cores, through an IPC pair", kEdgeColour, "stroke-width=\"2.6\"");
    legend_line(kMargin + 390, "feedback", kFeedbackColour, "stroke-width=\"1.4\" stroke-dasharray=\"7 4\"");
  }

  const Plan& plan_;
  const Layout& layout_;
  std::ostringstream out_;
};

}  // namespace

std::string graph_svg(const Plan& plan) {
  const Layout layout = lay_out(plan);
  return Svg(plan, layout).run();
}

}  // namespace svchain
