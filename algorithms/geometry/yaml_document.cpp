#include "algorithms/geometry/yaml_document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <yaml-cpp/yaml.h>

namespace svchain::geometry {

namespace {

constexpr int kMostValues = 100000;  // aliases can make a small file enormous

nlohmann::json scalar(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  if (node.Tag() == "!") return text;  // was quoted
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  long long whole = 0;
  if (const auto [stop, error] = std::from_chars(begin, end, whole); error == std::errc() && stop == end) {
    return whole;
  }
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error == std::errc() && stop == end && std::isfinite(number)) return number;
  if (text == "true" || text == "false") return text == "true";
  return text;
}

/// Throws YAML::Exception where there are more values than any calibration has.
nlohmann::json json_of(const YAML::Node& node, int depth, int& count) {
  if (++count > kMostValues || depth > json::kDeepest) {
    throw YAML::Exception(node.Mark(), "more values, or deeper ones, than a calibration has");
  }
  if (node.IsSequence()) {
    auto list = nlohmann::json::array();
    for (const auto& item : node) list.push_back(json_of(item, depth + 1, count));
    return list;
  }
  if (node.IsMap()) {
    auto map = nlohmann::json::object();
    for (const auto& member : node) {
      if (!member.first.IsScalar()) throw YAML::Exception(member.first.Mark(), "expected a name");
      map[member.first.Scalar()] = json_of(member.second, depth + 1, count);
    }
    return map;
  }
  if (node.IsScalar()) return scalar(node);
  return nullptr;
}

/// Place of the value a JSON pointer leads to, or of the nearest thing around it.
Location place_of(YAML::Node node, const std::string& pointer) {
  Location where{node.Mark().line + 1, node.Mark().column + 1};
  size_t begin = 1;
  while (begin < pointer.size()) {
    const size_t end = std::min(pointer.find('/', begin), pointer.size());
    const std::string key = pointer.substr(begin, end - begin);
    YAML::Node next;
    if (node.IsMap()) next.reset(node[key]);
    if (node.IsSequence()) next.reset(node[std::stoul(key)]);
    if (!next.IsDefined() || next.Mark().is_null()) break;
    node.reset(next);
    where = {node.Mark().line + 1, node.Mark().column + 1};
    begin = end + 1;
  }
  return where;
}

}  // namespace

Faults read_yaml(const std::filesystem::path& path, const std::function<void(const json::Value&)>& read) {
  const std::string file = path.string();
  const auto text = json::read_text(path);
  if (!text) return text.error();
  try {
    const YAML::Node root = YAML::Load(*text);
    int count = 0;
    const auto document = json::Document::parse(json_of(root, 0, count).dump(), file);
    if (!document) return document.error();
    Faults faults;
    read(json::Value(*document, faults));
    for (auto& fault : faults) {
      if (fault.file == file) fault.where = place_of(root, fault.pointer);
    }
    return faults;
  } catch (const YAML::Exception& error) {
    return {{file, {error.mark.line + 1, error.mark.column + 1}, {}, "not a YAML file: " + error.msg}};
  } catch (const nlohmann::json::exception&) {
    return {{file, {}, {}, "not a YAML file: its text is not UTF-8"}};
  }
}

}  // namespace svchain::geometry
