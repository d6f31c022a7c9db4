#include "algorithms/geometry/opencv_yaml.h"

#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <optional>

namespace svchain::geometry {

namespace {

/// Keeps OpenCV from printing what it throws.
class SilentOpenCv {
 public:
  SilentOpenCv()
      : before_(cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; })) {
  }
  ~SilentOpenCv() { cv::redirectError(before_); }
  SilentOpenCv(const SilentOpenCv&) = delete;
  SilentOpenCv& operator=(const SilentOpenCv&) = delete;

 private:
  cv::ErrorCallback before_;
};

Result<std::string> text_of(const std::filesystem::path& path) {
  constexpr std::uintmax_t kLargest = 1 << 20;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return fail(path.string(), "no such file");
  if (std::filesystem::file_size(path, error) > kLargest) {
    return fail(path.string(), "larger than 1 MB, expected an OpenCV YAML file with a few matrices");
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) return fail(path.string(), "cannot be read");
  std::string text(std::istreambuf_iterator<char>(in), {});
  const bool has_header = text.starts_with("%YAML") || text.starts_with("<?xml") || text.starts_with("{");
  return has_header ? text : "%YAML:1.0\n---\n" + text;
}

std::string size_text(int rows, int cols) {
  return std::to_string(rows) + " x " + std::to_string(cols);
}

/// The matrix in a node, or what is wrong with it.
tl::expected<Eigen::MatrixXd, std::string> matrix_in(const cv::FileNode& node, const WantedMatrix& wanted) {
  cv::Mat read;
  try {
    read = node.mat();
  } catch (const cv::Exception&) {
    return tl::unexpected("\"" + wanted.name + "\" is no matrix");
  }
  if (read.empty() || read.dims != 2 || read.channels() != 1) {
    return tl::unexpected("\"" + wanted.name + "\" is no matrix");
  }
  const bool vector = wanted.rows == 1 || wanted.cols == 1;
  if (vector && read.rows == wanted.cols && read.cols == wanted.rows) read = read.t();
  if (read.rows != wanted.rows || read.cols != wanted.cols) {
    return tl::unexpected("\"" + wanted.name + "\" expected as " + size_text(wanted.rows, wanted.cols) +
                          ", got " + size_text(read.rows, read.cols));
  }
  cv::Mat_<double> numbers;
  read.convertTo(numbers, CV_64F);
  Eigen::MatrixXd matrix(wanted.rows, wanted.cols);
  for (int i = 0; i < wanted.rows; ++i) {
    for (int j = 0; j < wanted.cols; ++j) matrix(i, j) = numbers(i, j);
  }
  if (!matrix.allFinite()) return tl::unexpected("\"" + wanted.name + "\" holds a number that is none");
  return matrix;
}

}  // namespace

Result<std::vector<Eigen::MatrixXd>> read_opencv_yaml(const std::filesystem::path& path,
                                                      const std::vector<WantedMatrix>& wanted) {
  const auto text = text_of(path);
  if (!text) return tl::unexpected(text.error());

  const SilentOpenCv silent;
  cv::FileStorage storage;
  std::vector<std::string> known;
  try {
    storage.open(*text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::FileNode root = storage.root();
    if (root.isMap()) known = root.keys();
  } catch (const cv::Exception& e) {
    return fail(path.string(), "not an OpenCV YAML file: " + e.err);
  }
  if (known.empty()) return fail(path.string(), "not an OpenCV YAML file: it names nothing");

  Faults faults;
  std::vector<Eigen::MatrixXd> matrices;
  for (const auto& want : wanted) {
    matrices.emplace_back();
    const cv::FileNode node = storage[want.name];
    if (node.empty()) {
      if (!want.required) continue;
      faults.push_back({path.string(),
                        {},
                        {},
                        "\"" + want.name + "\" is missing" + did_you_mean(want.name, known) +
                            " (the file has: " + spoken_list(known) + ")"});
      continue;
    }
    auto matrix = matrix_in(node, want);
    if (matrix)
      matrices.back() = std::move(*matrix);
    else
      faults.push_back({path.string(), {}, {}, std::move(matrix.error())});
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return matrices;
}

}  // namespace svchain::geometry
