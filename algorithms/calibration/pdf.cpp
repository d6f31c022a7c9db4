// A PDF file in as few objects as there can be: catalogue, pages, one of the fonts that every reader has, and
// for each page its description and what is drawn on it (ISO 32000-1:2008).

#include <algorithm>
#include <charconv>
#include <cmath>

#include "algorithms/calibration/print_charts.h"

namespace svchain::calibration {

namespace {

constexpr double kPointsPerMetre = 72 / 0.0254;
constexpr double kLargestPage = 14400;  // in user units, by the standard's annex C

/// With a point and four decimals, whatever the locale.
std::string decimal(double value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 4).ptr;
  return {text, end};
}

std::string place(const Eigen::Vector2d& metres, double units_per_metre) {
  return decimal(metres.x() * units_per_metre) + " " + decimal(metres.y() * units_per_metre);
}

std::string quoted(const std::string& text) {
  std::string made = "(";
  for (const char c : text) {
    if (c == '(' || c == ')' || c == '\\') made += '\\';
    made += c;
  }
  return made + ")";
}

/// All polygons are one path, so that no seams show between them.
std::string drawing(const Sheet& sheet, double units_per_metre) {
  std::string text = "0 g\n";
  for (const auto& polygon : sheet.black) {
    const char* step = " m ";
    for (const auto& corner : polygon) {
      text += place(corner, units_per_metre) + step;
      step = " l ";
    }
    text += "h\n";
  }
  text += "f\n";
  for (const auto& label : sheet.labels) {
    text += "BT /F1 " + decimal(label.height_m * units_per_metre) + " Tf " +
            place(label.place_m, units_per_metre) + " Td " + quoted(label.text) + " Tj ET\n";
  }
  return text;
}

/// A page's two objects.
void add_page(const Sheet& sheet, std::vector<std::string>& objects) {
  const double unit = std::max(1.0, std::ceil(sheet.size_m.maxCoeff() * kPointsPerMetre / kLargestPage));
  const double units_per_metre = kPointsPerMetre / unit;
  const std::string content = drawing(sheet, units_per_metre);
  objects.push_back("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + place(sheet.size_m, units_per_metre) +
                    "]" + (unit > 1 ? " /UserUnit " + decimal(unit) : "") +
                    " /Resources << /Font << /F1 3 0 R >> >> /Contents " +
                    std::to_string(objects.size() + 2) + " 0 R >>");
  objects.push_back("<< /Length " + std::to_string(content.size()) + " >>\nstream\n" + content + "endstream");
}

/// The objects, numbered from 1, and the table of where they begin.
std::string file_of(const std::vector<std::string>& objects, const std::string& version) {
  std::string text = "%PDF-" + version + "\n%\xE2\xE3\xCF\xD3\n";
  std::string table = "0000000000 65535 f \n";
  for (size_t i = 0; i < objects.size(); ++i) {
    const std::string offset = std::to_string(text.size());
    table += std::string(10 - std::min<size_t>(10, offset.size()), '0') + offset + " 00000 n \n";
    text += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::string count = std::to_string(objects.size() + 1);
  const std::string start = std::to_string(text.size());
  return text + "xref\n0 " + count + "\n" + table + "trailer\n<< /Size " + count +
         " /Root 1 0 R >>\nstartxref\n" + start + "\n%%EOF\n";
}

}  // namespace

std::string pdf_of(const std::vector<Sheet>& sheets) {
  std::vector<std::string> objects = {"<< /Type /Catalog /Pages 2 0 R >>", "",
                                      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
  std::string kids;
  bool large = false;
  for (const auto& sheet : sheets) {
    kids += std::to_string(objects.size() + 1) + " 0 R ";
    add_page(sheet, objects);
    large = large || sheet.size_m.maxCoeff() * kPointsPerMetre > kLargestPage;
  }
  objects[1] = "<< /Type /Pages /Kids [ " + kids + "] /Count " + std::to_string(sheets.size()) + " >>";
  return file_of(objects, large ? "1.6" : "1.4");
}

}  // namespace svchain::calibration
