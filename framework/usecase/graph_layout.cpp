// Layered drawing after Sugiyama: long edges get a place of their own in every column they pass, each cell
// (lane, column) is ordered by the mean height of its neighbours, then moved to make edges straight.

#include "framework/usecase/graph_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace svchain {

namespace {

constexpr double kPortPitch = 19;
constexpr double kColumnGap = 74;   // without IPC ends
constexpr double kPassHeight = 16;  // of the room for a passing edge
constexpr double kSpacing = 18;     // between what stands in one cell
constexpr double kLanePadding = 18;
constexpr int kSweeps = 8;

/// A box, or the room for an edge that passes a column.
struct Item {
  int lane = 0, rank = 0;
  double height = 0, centre = 0;
};

/// Where an edge touches an item: the item's centre plus an offset.
struct Stop {
  int item = 0;
  double offset = 0;
};

class Drawing {
 public:
  explicit Drawing(const Plan& plan) : plan_(plan) {}

  Layout run() {
    place_boxes();
    for (const PlannedEdge& edge : plan_.edges) chains_.push_back(chain_of(edge));
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      stack();
      order_cells();
    }
    stack();
    for (int sweep = 0; sweep < kSweeps; ++sweep) straighten();
    finish();
    return std::move(layout_);
  }

 private:
  using Cell = std::pair<int, int>;  // lane, rank

  void place_boxes() {
    for (const PlannedLink& link : plan_.links) {
      BoxSpot box;
      box.inputs = spots(link.description.inputs, link.input_edges);
      box.outputs = spots(link.description.outputs, link.output_edges);
      const size_t rows = std::max(box.inputs.size(), box.outputs.size());
      box.height = kHeadHeight + kPortPitch * static_cast<double>(rows) + 4;
      box.width = box_width(link, box);
      columns_ = std::max(columns_, link.rank + 1);
      add_item({link.core, link.rank, box.height});
      layout_.boxes.push_back(std::move(box));
    }
  }

  static std::vector<PortSpot> spots(const std::vector<PortDescription>& ports,
                                     const std::vector<int>& edges) {
    std::vector<PortSpot> connected;
    for (size_t i = 0; i < ports.size(); ++i) {
      if (edges[i] != -1) connected.push_back({ports[i].name, 0});
    }
    for (size_t i = 0; i < connected.size(); ++i) {
      connected[i].y =
          kHeadHeight + kPortPitch * (static_cast<double>(i) + 0.5);  // from the box's top, for now
    }
    return connected;
  }

  static double box_width(const PlannedLink& link, const BoxSpot& box) {
    const auto longest = [](const std::vector<PortSpot>& ports) {
      size_t n = 0;
      for (const auto& port : ports) n = std::max(n, port.name.size());
      return static_cast<double>(n);
    };
    const double head = 8.1 * static_cast<double>(link.entry.name.size()) + 24;
    const double type = 5.8 * static_cast<double>(link.entry.type.size()) + 24;
    const double ports = 5.8 * (longest(box.inputs) + longest(box.outputs)) + 40;
    return std::max({92.0, head, type, ports});
  }

  int add_item(Item item) {
    items_.push_back(item);
    const int index = static_cast<int>(items_.size()) - 1;
    cells_[{item.lane, item.rank}].push_back(index);
    return index;
  }

  /// Offset of a port from its box's centre.
  double port_offset(int link, const std::vector<PortSpot>& ports, const std::string& name) const {
    const auto it =
        std::find_if(ports.begin(), ports.end(), [&](const auto& port) { return port.name == name; });
    return it->y - layout_.boxes[static_cast<size_t>(link)].height / 2;
  }

  std::vector<Stop> chain_of(const PlannedEdge& edge) {
    const PlannedLink& from = plan_.links[static_cast<size_t>(edge.from_link)];
    const PlannedLink& to = plan_.links[static_cast<size_t>(edge.to_link)];
    const auto& outputs = layout_.boxes[static_cast<size_t>(edge.from_link)].outputs;
    const auto& inputs = layout_.boxes[static_cast<size_t>(edge.to_link)].inputs;
    std::vector<Stop> chain = {{edge.from_link, port_offset(edge.from_link, outputs, edge.entry.from_port)}};
    const std::vector<int> columns = columns_passed(from.rank, to.rank);
    const int lane = columns.empty() ? 0 : freest_lane(from.core, to.core, columns);
    for (int column : columns) chain.push_back({add_item({lane, column, kPassHeight}), 0});
    chain.push_back({edge.to_link, port_offset(edge.to_link, inputs, edge.entry.to_port)});
    return chain;
  }

  /// An edge that leads back passes its own ends' columns too.
  static std::vector<int> columns_passed(int from, int to) {
    std::vector<int> columns;
    if (from < to) {
      for (int column = from + 1; column < to; ++column) columns.push_back(column);
    } else {
      for (int column = from; column >= to; --column) columns.push_back(column);
    }
    return columns;
  }

  int freest_lane(int from, int to, const std::vector<int>& columns) const {
    int best = from;
    size_t fewest = SIZE_MAX;
    const int step = to < from ? -1 : 1;
    for (int lane = from; lane != to + step; lane += step) {
      size_t crowd = 0;
      for (int column : columns) {
        if (const auto cell = cells_.find({lane, column}); cell != cells_.end()) crowd += cell->second.size();
      }
      if (crowd < fewest) {
        fewest = crowd;
        best = lane;
      }
    }
    return best;
  }

  double stack_height(const std::vector<int>& cell) const {
    double height = kSpacing * static_cast<double>(cell.size() - 1);
    for (int item : cell) height += items_[static_cast<size_t>(item)].height;
    return height;
  }

  /// Heights of lanes; every cell's items one below the other, in the lane's middle.
  void stack() {
    layout_.lanes.assign(plan_.cores.size(), {0, 60});
    for (const auto& [cell, items] : cells_) {
      LaneSpot& lane = layout_.lanes[static_cast<size_t>(cell.first)];
      lane.height = std::max(lane.height, stack_height(items) + 2 * kLanePadding);
    }
    double y = kMargin + kTitleHeight;
    for (LaneSpot& lane : layout_.lanes) {
      lane.y = y;
      y += lane.height + 6;
    }
    layout_.height = y - 6 + kLegendHeight;
    for (const auto& [cell, items] : cells_) {
      const LaneSpot& lane = layout_.lanes[static_cast<size_t>(cell.first)];
      double top = lane.y + (lane.height - stack_height(items)) / 2;
      for (int index : items) {
        Item& item = items_[static_cast<size_t>(index)];
        item.centre = top + item.height / 2;
        top += item.height + kSpacing;
      }
    }
  }

  double height_of(const Stop& stop) const {
    return items_[static_cast<size_t>(stop.item)].centre + stop.offset;
  }

  /// For every item, how much higher or lower its neighbours' ends of the edges stand, on average.
  std::vector<double> pulls() const {
    std::vector<double> sum(items_.size(), 0), weight(items_.size(), 0);
    for (const auto& chain : chains_) {
      for (size_t i = 0; i + 1 < chain.size(); ++i) {
        const double rise = height_of(chain[i + 1]) - height_of(chain[i]);
        const auto a = static_cast<size_t>(chain[i].item), b = static_cast<size_t>(chain[i + 1].item);
        sum[a] += rise;
        sum[b] -= rise;
        weight[a] += 1;
        weight[b] += 1;
      }
    }
    for (size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(1.0, weight[i]);
    return sum;
  }

  void order_cells() {
    const auto pull = pulls();
    const auto wish = [&](int item) {
      return items_[static_cast<size_t>(item)].centre + pull[static_cast<size_t>(item)];
    };
    for (auto& [cell, items] : cells_) {
      std::stable_sort(items.begin(), items.end(), [&](int a, int b) { return wish(a) < wish(b); });
    }
  }

  void straighten() {
    const auto pull = pulls();
    for (const auto& [cell, items] : cells_) {
      const LaneSpot& lane = layout_.lanes[static_cast<size_t>(cell.first)];
      double shift = 0;
      for (int item : items) shift += pull[static_cast<size_t>(item)] / static_cast<double>(items.size());
      const Item& first = items_[static_cast<size_t>(items.front())];
      const Item& last = items_[static_cast<size_t>(items.back())];
      const double up = lane.y + kLanePadding - (first.centre - first.height / 2);
      const double down = lane.y + lane.height - kLanePadding - (last.centre + last.height / 2);
      shift = std::min(std::max(shift, up), std::max(up, down));
      for (int item : items) items_[static_cast<size_t>(item)].centre += shift;
    }
  }

  void finish() {
    std::vector<double> widths(static_cast<size_t>(columns_), 0), lefts;
    for (size_t i = 0; i < layout_.boxes.size(); ++i) {
      double& width = widths[static_cast<size_t>(plan_.links[i].rank)];
      width = std::max(width, layout_.boxes[i].width);
    }
    double x = kMargin + kLaneLabelWidth;
    for (int column = 0; column < columns_; ++column) {
      x += gap_before(column);
      lefts.push_back(x);
      x += widths[static_cast<size_t>(column)];
    }
    layout_.width = std::max(x + 24 + loop_room() + kMargin, 640.0);
    for (size_t i = 0; i < layout_.boxes.size(); ++i) set_box(i, lefts, widths);
    for (size_t e = 0; e < chains_.size(); ++e) set_way(e, lefts, widths);
  }

  double gap_before(int column) const {
    if (column == 0) return 24 + (has_pill(0, false) ? kPillWidth : 0);
    return kColumnGap + (has_pill(column - 1, true) ? kPillWidth : 0) +
           (has_pill(column, false) ? kPillWidth : 0);
  }

  bool has_pill(int column, bool at_output) const {
    return std::any_of(plan_.edges.begin(), plan_.edges.end(), [&](const PlannedEdge& edge) {
      return edge.ipc &&
             plan_.links[static_cast<size_t>(at_output ? edge.from_link : edge.to_link)].rank == column;
    });
  }

  /// Room to the right of the last column for an edge that leads back from there.
  double loop_room() const {
    for (const PlannedEdge& edge : plan_.edges) {
      if (edge.entry.feedback && plan_.links[static_cast<size_t>(edge.from_link)].rank == columns_ - 1)
        return 90;
    }
    return 0;
  }

  void set_box(size_t i, const std::vector<double>& lefts, const std::vector<double>& widths) {
    BoxSpot& box = layout_.boxes[i];
    const auto column = static_cast<size_t>(plan_.links[i].rank);
    box.x = lefts[column];
    box.width = widths[column];
    box.y = items_[i].centre - box.height / 2;
    for (auto& port : box.inputs) port.y += box.y;
    for (auto& port : box.outputs) port.y += box.y;
  }

  void set_way(size_t e, const std::vector<double>& lefts, const std::vector<double>& widths) {
    const auto& chain = chains_[e];
    const PlannedEdge& edge = plan_.edges[e];
    const BoxSpot& from = layout_.boxes[static_cast<size_t>(edge.from_link)];
    const BoxSpot& to = layout_.boxes[static_cast<size_t>(edge.to_link)];
    const double pill = edge.ipc ? kPillWidth + kPillGap : 0;
    auto& points = layout_.ways[e].points;
    points.push_back({from.x + from.width + pill, height_of(chain.front()), 1});
    const int direction = plan_.links[static_cast<size_t>(edge.from_link)].rank <
                                  plan_.links[static_cast<size_t>(edge.to_link)].rank
                              ? 1
                              : -1;
    for (size_t i = 1; i + 1 < chain.size(); ++i) {
      const auto column = static_cast<size_t>(items_[static_cast<size_t>(chain[i].item)].rank);
      const double left = lefts[column], right = lefts[column] + widths[column];
      const double y = height_of(chain[i]);
      points.push_back({direction > 0 ? left : right, y, direction});
      points.push_back({direction > 0 ? right : left, y, direction});
    }
    points.push_back({to.x - pill, height_of(chain.back()), 1});
  }

  const Plan& plan_;
  Layout layout_{0, 0, {}, {}, std::vector<WaySpot>(plan_.edges.size())};
  int columns_ = 0;
  std::vector<Item> items_;  // the boxes first, by link
  std::map<Cell, std::vector<int>> cells_;
  std::vector<std::vector<Stop>> chains_;  // by edge
};

}  // namespace

Layout lay_out(const Plan& plan) {
  return Drawing(plan).run();
}

}  // namespace svchain
