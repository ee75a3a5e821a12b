#include "fem/linear/multigrid/aggregation.h"

#include <algorithm>
#include <map>
#include <utility>

namespace geneva::fem {

namespace {

class Aggregation {
 public:
  Aggregation(const std::vector<std::vector<int>>& neighbours,
              const std::vector<unsigned int>& bodies, const unsigned int minimum_nodes)
      : neighbours_(neighbours),
        bodies_(bodies),
        minimum_nodes_(minimum_nodes),
        result_{std::vector<int>(bodies.size(), no_aggregate), {}} {}

  Aggregates run() {
    for (std::size_t node = 0; node < bodies_.size(); ++node)
      if (is_coupled(node) && !is_taken(node) && !has_taken_neighbour(node)) begin_aggregate(node);
    join_neighbours();
    for (std::size_t node = 0; node < bodies_.size(); ++node)
      if (is_coupled(node) && !is_taken(node)) begin_aggregate(node);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_coupled(const std::size_t node) const { return !neighbours_[node].empty(); }
  [[nodiscard]] bool is_taken(const std::size_t node) const {
    return result_.of_nodes[node] != no_aggregate;
  }

  /// The neighbours in the node's own body.
  template <typename Visit>
  void visit_neighbours(const std::size_t node, const Visit& visit) const {
    for (const int neighbour : neighbours_[node]) {
      const auto other = static_cast<std::size_t>(neighbour);
      if (bodies_[other] == bodies_[node]) visit(other);
    }
  }

  [[nodiscard]] bool has_taken_neighbour(const std::size_t node) const {
    bool result = false;
    visit_neighbours(node, [&](const std::size_t other) { result = result || is_taken(other); });
    return result;
  }

  void begin_aggregate(const std::size_t node) {
    std::vector<std::size_t> members{node};
    visit_neighbours(node, [&](const std::size_t other) {
      if (other != node && !is_taken(other)) members.push_back(other);
    });
    if (members.size() < minimum_nodes_) return;
    for (const std::size_t member : members)
      result_.of_nodes[member] = static_cast<int>(result_.bodies.size());
    result_.bodies.push_back(bodies_[node]);
  }

  void join_neighbours() {
    const std::vector<int> begun = result_.of_nodes;
    for (std::size_t node = 0; node < bodies_.size(); ++node) {
      if (is_taken(node)) continue;
      std::map<int, int> counts;
      visit_neighbours(node, [&](const std::size_t other) {
        if (begun[other] != no_aggregate) ++counts[begun[other]];
      });
      const auto most = std::max_element(
          counts.begin(), counts.end(),
          [](const auto& one, const auto& other) { return one.second < other.second; });
      if (most != counts.end()) result_.of_nodes[node] = most->first;
    }
  }

  const std::vector<std::vector<int>>& neighbours_;
  const std::vector<unsigned int>& bodies_;
  unsigned int minimum_nodes_;
  Aggregates result_;
};

}  // namespace

Aggregates aggregate(const std::vector<std::vector<int>>& neighbours,
                     const std::vector<unsigned int>& bodies, const unsigned int minimum_nodes) {
  return Aggregation(neighbours, bodies, minimum_nodes).run();
}

}  // namespace geneva::fem
