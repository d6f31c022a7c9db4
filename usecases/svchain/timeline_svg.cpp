#include "usecases/svchain/timeline_svg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "framework/usecase/palette.h"
#include "framework/usecase/svg_text.h"

namespace svchain::program {

namespace {

constexpr double kMargin = 20, kNames = 76, kPlot = 1400;
constexpr double kHead = 64, kLane = 34, kGap = 20, kAxis = 40, kLegendLine = 22;
constexpr double kLetter = 5.6;  // of 10 px, on the average
const std::string kInk = "#222b36", kGrey = "#6a7480", kArrow = "#5b6470", kRed = "#c0392b";

/// Hundredths of a pixel are enough.
std::string at(double v) {
  std::ostringstream out;
  out << std::round(v * 100) / 100;
  return out.str();
}

std::string in_ms(double ms, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, ms);
  return text;
}

/// 1, 2 or 5 times a power of ten, about a tenth of the span.
double tick_of(double span) {
  const double power = std::pow(10, std::floor(std::log10(span / 10)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= span / 10) return step * power;
  }
  return 10 * power;
}

class Picture {
 public:
  Picture(const TraceFile& trace, const TimePart& part) : trace_(trace), part_(part) {
    place_legend();
    bottom_ = kHead + static_cast<double>(trace.tracks.size()) * (kLane + kGap);
    width_ = kMargin + kNames + kPlot + kMargin;
    height_ = bottom_ + kAxis + legend_height_ + kMargin;
  }

  std::string text() {
    out_
        << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << at(width_) << "\" height=\"" << at(height_)
        << "\" viewBox=\"0 0 " << at(width_) << " " << at(height_)
        << "\" font-family=\"Helvetica, Arial, sans-serif\">\n<defs><marker id=\"arrow\" viewBox=\"0 0 8 8\" "
           "refX=\"7\" refY=\"4\" markerWidth=\"6\" markerHeight=\"6\" markerUnits=\"userSpaceOnUse\" "
           "orient=\"auto\"><path d=\"M0,0.8 L8,4 L0,7.2 z\" fill=\""
        << kArrow << "\"/></marker></defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    title();
    axis();
    for (size_t track = 0; track < trace_.tracks.size(); ++track) lane(track);
    for (const TraceSlice& slice : trace_.slices) box(slice);
    for (const TraceArrow& arrow : trace_.arrows) line(arrow);
    for (const TraceDrop& drop : trace_.drops) mark(drop);
    legend();
    out_ << "</svg>\n";
    return out_.str();
  }

 private:
  static double top_of(size_t track) { return kHead + static_cast<double>(track) * (kLane + kGap); }
  double x_of(double ms) const {
    return kMargin + kNames + kPlot * (ms - part_.from_ms) / (part_.to_ms - part_.from_ms);
  }
  double x_within(double ms) const { return x_of(std::clamp(ms, part_.from_ms, part_.to_ms)); }
  bool shows(double from_ms, double to_ms) const { return from_ms <= part_.to_ms && to_ms >= part_.from_ms; }
  const Colour& colour_of(const std::string& link) const {
    const auto place = std::find(trace_.links.begin(), trace_.links.end(), link);
    return colour_of_core(static_cast<int>(place - trace_.links.begin()));
  }

  void words(double x, double y, int size, const std::string& colour, const char* anchor,
             const std::string& what, bool bold = false) {
    out_ << "<text x=\"" << at(x) << "\" y=\"" << at(y) << "\" font-size=\"" << size << "\" fill=\"" << colour
         << "\" text-anchor=\"" << anchor << "\"" << (bold ? " font-weight=\"bold\"" : "") << ">"
         << svg_text(what) << "</text>\n";
  }

  void title() {
    std::string name = trace_.use_case.empty() ? "Timeline" : trace_.use_case;
    if (!trace_.soc.empty()) name += " on " + trace_.soc;
    words(kMargin, 30, 18, kInk, "start", name + (trace_.modelled ? ", modelled time" : ""), true);
    std::string said = in_ms(part_.from_ms, 3) + " to " + in_ms(part_.to_ms, 3) + " ms of " +
                       in_ms(trace_.begin_ms(), 3) + " to " + in_ms(trace_.end_ms(), 3) + " ms";
    if (!part_.why.empty()) said += ": " + part_.why;
    if (trace_.lost_events > 0)
      said += "; " + std::to_string(trace_.lost_events) + " events were lost when the recorders were full";
    words(kMargin, 48, 11, kGrey, "start", said);
  }

  void axis() {
    const double step = tick_of(part_.to_ms - part_.from_ms);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const auto first = static_cast<long long>(std::ceil(part_.from_ms / step - 1e-9));
    const auto last = static_cast<long long>(std::floor(part_.to_ms / step + 1e-9));
    for (long long i = first; i <= last; ++i) {
      const double x = x_of(static_cast<double>(i) * step);
      out_ << "<path d=\"M" << at(x) << "," << at(kHead - 6) << " V" << at(bottom_)
           << "\" stroke=\"#e3e7ec\" fill=\"none\"/>\n";
      words(x, bottom_ + 14, 10, kGrey, "middle", in_ms(static_cast<double>(i) * step, decimals));
    }
    words(kMargin + kNames + kPlot, bottom_ + 28, 10, kGrey, "end", "ms");
  }

  void lane(size_t track) {
    const double top = top_of(track);
    words(kMargin, top + kLane / 2 + 4, 13, kInk, "start", trace_.tracks[track], true);
    out_ << "<path d=\"M" << at(kMargin + kNames) << "," << at(top + kLane) << " h" << at(kPlot)
         << "\" stroke=\"#b8c0ca\" fill=\"none\"/>\n";
  }

  void box(const TraceSlice& slice) {
    if (!shows(slice.begin_ms, slice.end_ms)) return;
    const Colour& colour = colour_of(slice.link);
    const double x = x_within(slice.begin_ms);
    const double width = std::max(1.0, x_within(slice.end_ms) - x);
    const double top = top_of(slice.track);
    const std::string number = slice.frame ? std::to_string(*slice.frame) : "";
    out_ << "<rect x=\"" << at(x) << "\" y=\"" << at(top) << "\" width=\"" << at(width) << "\" height=\""
         << at(kLane) << "\" fill=\"" << colour.box << "\" stroke=\"" << colour.edge << "\" stroke-width=\""
         << (width < 3 ? "0.5" : "1") << "\"><title>" << svg_text(slice.link)
         << (number.empty() ? "" : ", frame ") << number << ": " << in_ms(slice.begin_ms, 3) << " to "
         << in_ms(slice.end_ms, 3) << " ms</title></rect>\n";
    const auto fits = [width](const std::string& what) {
      return !what.empty() && static_cast<double>(what.size()) * kLetter + 4 <= width;
    };
    const double middle = x + width / 2;
    if (fits(slice.link)) {
      words(middle, top + 14, 10, kInk, "middle", slice.link);
      words(middle, top + 27, 10, kInk, "middle", number, true);
    } else if (fits(number)) {
      words(middle, top + kLane / 2 + 4, 10, kInk, "middle", number, true);
    }
  }

  /// From the border of one lane to the nearest border of the other.
  void line(const TraceArrow& arrow) {
    if (arrow.from.at_ms < part_.from_ms || arrow.to.at_ms > part_.to_ms) return;
    const bool down = arrow.to.track > arrow.from.track;
    const double from_y = top_of(arrow.from.track) + (down ? kLane : 0);
    const double to_y = top_of(arrow.to.track) + (down ? 0 : kLane);
    const double bend = (down ? 1 : -1) * std::max(8.0, std::abs(to_y - from_y) / 3);
    const double from_x = x_of(arrow.from.at_ms), to_x = x_of(arrow.to.at_ms);
    out_ << "<path d=\"M" << at(from_x) << "," << at(from_y) << " C" << at(from_x) << "," << at(from_y + bend)
         << " " << at(to_x) << "," << at(to_y - bend) << " " << at(to_x) << "," << at(to_y)
         << "\" fill=\"none\" stroke=\"" << kArrow
         << "\" stroke-width=\"0.9\" stroke-opacity=\"0.75\" marker-end=\"url(#arrow)\"><title>"
         << svg_text(arrow.edge) << "</title></path>\n";
  }

  void mark(const TraceDrop& drop) {
    if (!shows(drop.where.at_ms, drop.where.at_ms)) return;
    out_ << "<path d=\"M" << at(x_of(drop.where.at_ms)) << "," << at(top_of(drop.where.track) - 1)
         << " l-4,-8 h8 z\" fill=\"" << kRed << "\"><title>" << svg_text(drop.reason) << ", "
         << in_ms(drop.where.at_ms, 3) << " ms</title></path>\n";
  }

  struct LegendEntry {
    double x = 0, y = 0;
    std::string what, fill, stroke;
  };

  void place_legend() {
    double x = kMargin + kNames, y = 0;
    const auto put = [&](const std::string& what, const std::string& fill, const std::string& stroke) {
      const double width = 34 + static_cast<double>(what.size()) * 6.2;
      if (x + width > kMargin + kNames + kPlot) {
        x = kMargin + kNames;
        y += kLegendLine;
      }
      entries_.push_back({x, y, what, fill, stroke});
      x += width;
    };
    for (const std::string& link : trace_.links) put(link, colour_of(link).box, colour_of(link).edge);
    put("a frame goes to another core", "none", kArrow);
    if (!trace_.drops.empty()) put("dropped", kRed, kRed);
    legend_height_ = y + kLegendLine;
  }

  void legend() {
    for (const LegendEntry& entry : entries_) {
      const double y = bottom_ + kAxis + entry.y;
      if (entry.fill == "none") {
        out_ << "<path d=\"M" << at(entry.x) << "," << at(y + 7) << " h16\" stroke=\"" << entry.stroke
             << "\" marker-end=\"url(#arrow)\"/>\n";
      } else {
        out_ << "<rect x=\"" << at(entry.x) << "\" y=\"" << at(y) << "\" width=\"16\" height=\"13\" fill=\""
             << entry.fill << "\" stroke=\"" << entry.stroke << "\"/>\n";
      }
      words(entry.x + 22, y + 10.5, 11, kInk, "start", entry.what);
    }
  }

  const TraceFile& trace_;
  const TimePart& part_;
  double bottom_ = 0, width_ = 0, height_ = 0, legend_height_ = 0;
  std::vector<LegendEntry> entries_;
  std::ostringstream out_;
};

}  // namespace

std::string timeline_svg(const TraceFile& trace, const TimePart& part) {
  return Picture(trace, part).text();
}

}  // namespace svchain::program
