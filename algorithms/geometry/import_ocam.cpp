#include "algorithms/geometry/import_ocam.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "algorithms/geometry/import_fields.h"
#include "algorithms/geometry/lens_json.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

struct Number {
  double value;
  int line;
};

/// Every number of the file, or what is none.
Result<std::vector<Number>> numbers_in(const std::string& text, const std::string& file) {
  std::vector<Number> numbers;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word;
    while (words >> word) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end != '\0' || !std::isfinite(value)) {
        return tl::unexpected(
            Faults{{file, {number, 1}, {}, "expected a number, got \"" + word.substr(0, 40) + "\""}});
      }
      numbers.push_back({value, number});
    }
  }
  return numbers;
}

/// Takes the file's numbers one group after the other; empty after the first fault.
class Groups {
 public:
  Groups(std::vector<Number> numbers, std::string file)
      : numbers_(std::move(numbers)), file_(std::move(file)) {}

  std::vector<double> take(size_t count, const std::string& what) {
    if (!faults_.empty()) return {};
    if (numbers_.size() - at_ < count) {
      faults_.push_back({file_, {}, {}, "ends before " + what});
      return {};
    }
    std::vector<double> group;
    for (size_t i = 0; i < count; ++i) group.push_back(numbers_[at_++].value);
    return group;
  }
  std::vector<double> take_counted(const std::string& what) {
    const auto count = take(1, what);
    if (count.empty()) return {};
    constexpr double kMost = 64;
    if (!(count[0] >= 1 && count[0] <= kMost && count[0] == std::floor(count[0]))) {
      faults_.push_back({file_,
                         {numbers_[at_ - 1].line, 1},
                         {},
                         "expected how many coefficients follow, 1 to 64: " + what});
      return {};
    }
    return take(static_cast<size_t>(count[0]), what);
  }
  const Faults& faults() const { return faults_; }

 private:
  std::vector<Number> numbers_;
  std::string file_;
  size_t at_ = 0;
  Faults faults_;
};

/// Reads what a rig file with these values would be, so that the same rules hold; the faults are this file's.
template <class Read>
Faults by_the_rules(const ordered_json& values, const std::string& file, Read read) {
  const auto document = json::Document::parse(values.dump(), file);
  if (!document) return document.error();
  Faults faults;
  read(json::Value(*document, faults));
  for (auto& fault : faults) fault.where = {};
  return faults;
}

Faults read_camera(const std::filesystem::path& path, Camera& camera) {
  const std::string file = path.string();
  const auto text = json::read_text(path);
  if (!text) return text.error();
  auto numbers = numbers_in(*text, file);
  if (!numbers) return numbers.error();
  Groups groups(std::move(*numbers), file);
  groups.take_counted("the direct polynomial");
  const auto inverse = groups.take_counted("the inverse polynomial");
  const auto centre = groups.take(2, "the centre's row and column");
  const auto affine = groups.take(3, "the affine parameters c, d, e");
  const auto size = groups.take(2, "the image's height and width");
  if (!groups.faults().empty()) return groups.faults();

  const ordered_json values = {
      {"lens",
       {{"model", "ocam"}, {"inverse_polynomial", inverse}, {"affine", affine}, {"centre_px", centre}}},
      {"height", std::llround(size[0])},
      {"width", std::llround(size[1])}};
  return by_the_rules(values, file, [&](const json::Value& root) {
    camera.image_size_px = image_size(root.required("width"), root.required("height"));
    camera.lens = read_lens(root.required("lens"));
  });
}

}  // namespace

Result<Rig> import_ocam(const std::vector<std::filesystem::path>& files, const Rig& nominal) {
  return import_camera_files(files, nominal, read_camera);
}

}  // namespace svchain::geometry
