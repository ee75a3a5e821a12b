#include "api/source_pressure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace geneva::api {

namespace {

/// Nodes of a field by body and place, which is the same to a billionth of the model wherever it
/// was computed.
class NodesByPlace {
 public:
  explicit NodesByPlace(const post::NodalFields& fields) {
    double extent = 0.;
    for (const Vector& place : fields.places)
      for (const double component : place) extent = std::max(extent, std::abs(component));
    cell_ = 1e-8 * extent;
    const std::vector<unsigned int> bodies = post::bodies_of_nodes(fields);
    for (std::size_t node = 0; node < fields.places.size(); ++node)
      nodes_[key(fields.places[node], bodies[node], {})].push_back(node);
  }

  [[nodiscard]] std::vector<std::size_t> at(const SourceNode& source) const {
    std::vector<std::size_t> found;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const auto there =
          nodes_.find(key(source.place, source.body,
                          {neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1}));
      if (there != nodes_.end())
        found.insert(found.end(), there->second.begin(), there->second.end());
    }
    return found;
  }

 private:
  using Key = std::array<long, 4>;

  [[nodiscard]] Key key(const Vector& place, const unsigned int body,
                        const std::array<int, 3>& offset) const {
    Key result{0, 0, 0, static_cast<long>(body)};
    for (std::size_t i = 0; i < 3; ++i) result[i] = std::lround(place[i] / cell_) + offset[i];
    return result;
  }

  double cell_;
  std::map<Key, std::vector<std::size_t>> nodes_;
};

}  // namespace

post::PressureEnvelope pressure_envelope(const std::vector<FoundStep>& steps,
                                         const post::NodalFields& fields) {
  const std::size_t n_nodes = fields.places.size();
  post::PressureEnvelope greatest{std::vector<double>(n_nodes, 0.),
                                  std::vector<double>(n_nodes, 0.)};
  const NodesByPlace nodes(fields);
  for (std::size_t step = 0; step < steps.size(); ++step)
    for (const SourceNode& source : steps[step].sources) {
      if (source.pressure <= 0.) continue;
      for (const std::size_t node : nodes.at(source)) {
        if (source.pressure <= greatest.pressure[node]) continue;
        greatest.pressure[node] = source.pressure;
        greatest.when[node] = static_cast<double>(step + 1);
      }
    }
  return greatest;
}

}  // namespace geneva::api
