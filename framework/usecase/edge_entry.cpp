#include <algorithm>
#include <string_view>

#include "framework/usecase/entries.h"
#include "framework/usecase/place.h"

namespace svchain {

namespace {

struct End {
  std::string link, port;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// "synthesis.lut"
std::optional<End> parse_end(std::string_view text) {
  text = trimmed(text);
  const auto dot = text.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  End end{std::string(text.substr(0, dot)), std::string(text.substr(dot + 1))};
  if (!is_name(end.link) || !is_name(end.port)) return std::nullopt;
  return end;
}

std::optional<End> read_end(const json::Value& value) {
  const std::string text = value.string();
  auto end = parse_end(text);
  if (!end && value.is_string()) value.fault("expected \"LINK.PORT\", got \"" + text + "\"");
  return end;
}

std::optional<EdgeEntry> joined(const std::optional<End>& from, const std::optional<End>& to) {
  if (!from || !to) return std::nullopt;
  EdgeEntry edge;
  edge.from_link = from->link;
  edge.from_port = from->port;
  edge.to_link = to->link;
  edge.to_port = to->port;
  return edge;
}

/// "dup.out1 -> synthesis.frames"
std::optional<EdgeEntry> read_arrow(const json::Value& value) {
  const std::string text = value.string();
  const auto arrow = text.find("->");
  std::optional<EdgeEntry> edge;
  if (arrow != std::string::npos) {
    edge = joined(parse_end(std::string_view(text).substr(0, arrow)),
                  parse_end(std::string_view(text).substr(arrow + 2)));
  }
  if (!edge) value.fault("expected \"LINK.PORT -> LINK.PORT\", got \"" + text + "\"");
  return edge;
}

std::optional<EdgeEntry> read_object(const json::Value& value) {
  value.only({"from", "to", "depth", "policy", "feedback"});
  const auto from = read_end(value.required("from"));
  auto edge = joined(from, read_end(value.required("to")));
  const auto depth = value.optional("depth").integer({1, kDeepestEdge, "frames"}, EdgeEntry{}.depth);
  const auto policy = value.optional("policy").choice(kPolicyNames, kPolicyNames.front());
  const bool feedback = value.optional("feedback").boolean();
  if (!edge) return edge;
  edge->depth = static_cast<int>(depth);
  edge->policy =
      static_cast<Policy>(std::find(kPolicyNames.begin(), kPolicyNames.end(), policy) - kPolicyNames.begin());
  edge->feedback = feedback;
  return edge;
}

void check_link(const json::Value& value, const std::string& link,
                const std::vector<std::string>& link_names) {
  if (std::find(link_names.begin(), link_names.end(), link) != link_names.end()) return;
  value.fault("there is no link \"" + link + "\"" + did_you_mean(link, link_names) +
              (link_names.empty() ? "" : " (links: " + spoken_list(link_names) + ")"));
}

}  // namespace

std::optional<EdgeEntry> read_edge(const json::Value& value, const std::vector<std::string>& link_names) {
  std::optional<EdgeEntry> edge;
  if (value.is_string()) {
    edge = read_arrow(value);
  } else if (value.is_object()) {
    edge = read_object(value);
  } else {
    value.fault("expected \"LINK.PORT -> LINK.PORT\" or an object with \"from\" and \"to\"");
  }
  if (!edge) return edge;
  edge->origin = origin_of(value);
  check_link(value.is_object() ? value.optional("from") : value, edge->from_link, link_names);
  check_link(value.is_object() ? value.optional("to") : value, edge->to_link, link_names);
  return edge;
}

}  // namespace svchain
