// Order and cycles: links are ranked as their inputs allow (Kahn's algorithm); where none can go on, what is
// left holds a cycle, which is reported and cut, so that one pass finds all of them.

#include <algorithm>

#include "framework/usecase/plan_steps.h"

namespace svchain {

namespace {

class Ranking {
 public:
  Ranking(Plan& plan, Faults& faults)
      : plan_(plan), faults_(faults), waiting_(plan.links.size(), 0), ranked_(plan.links.size(), false) {
    cut_.reserve(plan.edges.size());
    for (const PlannedEdge& edge : plan.edges) {
      cut_.push_back(edge.entry.feedback);
      if (!edge.entry.feedback) ++waiting_[static_cast<size_t>(edge.to_link)];
    }
  }

  void run() {
    while (true) {
      const auto next = find([&](size_t link) { return !ranked_[link] && waiting_[link] == 0; });
      if (next != plan_.links.size()) {
        rank(next);
        continue;
      }
      const auto stuck = find([&](size_t link) { return !ranked_[link]; });
      if (stuck == plan_.links.size()) return;
      cut_cycle(stuck);
    }
  }

 private:
  template <class Test>
  size_t find(Test test) const {
    size_t link = 0;
    while (link < plan_.links.size() && !test(link)) ++link;
    return link;
  }

  void rank(size_t link) {
    ranked_[link] = true;
    for (size_t e = 0; e < plan_.edges.size(); ++e) {
      const PlannedEdge& edge = plan_.edges[e];
      if (cut_[e] || edge.from_link != static_cast<int>(link)) continue;
      const auto to = static_cast<size_t>(edge.to_link);
      --waiting_[to];
      plan_.links[to].rank = std::max(plan_.links[to].rank, plan_.links[link].rank + 1);
    }
  }

  /// An edge into a stuck link that comes from another stuck link: there always is one.
  size_t edge_from_stuck(size_t link) const {
    size_t e = 0;
    while (cut_[e] || plan_.edges[e].to_link != static_cast<int>(link) ||
           ranked_[static_cast<size_t>(plan_.edges[e].from_link)]) {
      ++e;
    }
    return e;
  }

  void cut_cycle(size_t stuck) {
    std::vector<size_t> way;  // edges walked against their direction
    std::vector<int> place(plan_.links.size(), -1);
    size_t link = stuck;
    while (place[link] == -1) {
      place[link] = static_cast<int>(way.size());
      way.push_back(edge_from_stuck(link));
      link = static_cast<size_t>(plan_.edges[way.back()].from_link);
    }
    std::vector<size_t> cycle(way.rbegin(), way.rend() - place[link]);
    // It is told from the link that stands first in the file.
    const auto first = std::min_element(cycle.begin(), cycle.end(), [&](size_t a, size_t b) {
      return plan_.edges[a].from_link < plan_.edges[b].from_link;
    });
    std::rotate(cycle.begin(), first, cycle.end());
    report(cycle);
    cut_[cycle.back()] = true;
    --waiting_[static_cast<size_t>(plan_.edges[cycle.back()].to_link)];
  }

  void report(const std::vector<size_t>& cycle) {
    std::string links = plan_.edges[cycle.front()].entry.from_link;
    for (size_t e : cycle) links += " -> " + plan_.edges[e].entry.to_link;
    faults_.push_back(plan_.edges[cycle.back()].entry.origin.fault(
        "these links wait for each other: " + links +
        "; the edge that closes a cycle needs \"feedback\": true"));
  }

  Plan& plan_;
  Faults& faults_;
  std::vector<bool> cut_;     // by edge
  std::vector<int> waiting_;  // by link: edges whose source has no rank yet
  std::vector<bool> ranked_;  // by link
};

bool leads_back(const Plan& plan, const PlannedEdge& feedback) {
  std::vector<bool> reached(plan.links.size(), false);
  std::vector<int> open = {feedback.to_link};
  while (!open.empty()) {
    const int link = open.back();
    open.pop_back();
    if (link == feedback.from_link) return true;
    if (reached[static_cast<size_t>(link)]) continue;
    reached[static_cast<size_t>(link)] = true;
    for (const PlannedEdge& edge : plan.edges) {
      if (edge.from_link == link) open.push_back(edge.to_link);
    }
  }
  return false;
}

}  // namespace

void order_links(Plan& plan, Faults& faults) {
  Ranking(plan, faults).run();
  for (const PlannedEdge& edge : plan.edges) {
    if (!edge.entry.feedback || leads_back(plan, edge)) continue;
    faults.push_back(edge.entry.origin.fault(
        "\"" + edge.entry.name() + "\" is marked feedback but closes no cycle: \"" + edge.entry.from_link +
        "\" gets nothing from \"" + edge.entry.to_link + "\""));
  }
  for (size_t i = 0; i < plan.links.size(); ++i) plan.source_to_sink.push_back(static_cast<int>(i));
  std::stable_sort(plan.source_to_sink.begin(), plan.source_to_sink.end(), [&](int a, int b) {
    return plan.links[static_cast<size_t>(a)].rank < plan.links[static_cast<size_t>(b)].rank;
  });
}

}  // namespace svchain
