#include "post/output/passing_pressure.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "post/output/slot_passing.h"

namespace geneva::post {

PassingContact passing_contact(const CycleFields& own, const std::vector<bool>& turning,
                               const std::vector<CycleCurvePoint>& curve, const double reach) {
  const std::vector<bool> turns = nodes_that_turn(own.fields, turning);
  const std::vector<unsigned int> bodies = bodies_of_nodes(own.fields);
  const SlotPassing passing(own, turning, curve);
  const double on_surface = SlotPassing::near * passing.pin_radius();
  const std::vector<double> zeros(turns.size(), 0.);
  PassingContact found{{zeros, zeros}, zeros, std::vector<bool>(turns.size(), false)};
  std::set<unsigned int> touching;
  for (std::size_t node = 0; node < turns.size(); ++node) {
    found.depth[node] = passing.depth(own.fields.places[node], turns[node]);
    found.is_surface[node] = std::abs(found.depth[node]) < on_surface;
    if (found.is_surface[node]) touching.insert(bodies[node]);
  }
  for (std::size_t node = 0; node < turns.size(); ++node) {
    double& depth = found.depth[node];
    const bool is_within = depth > -on_surface && depth < std::max(reach, on_surface);
    depth = std::max(depth, 0.);
    if (!is_within || touching.count(bodies[node]) == 0) continue;
    const auto pass = passing.greatest(own.fields.places[node], turns[node]);
    if (!pass) continue;
    found.greatest.pressure[node] = pass->pressure;
    found.greatest.when[node] = pass->when;
  }
  return found;
}

PressureEnvelope surface_pressure(PassingContact passing) {
  for (std::size_t node = 0; node < passing.is_surface.size(); ++node) {
    if (passing.is_surface[node]) continue;
    passing.greatest.pressure[node] = 0.;
    passing.greatest.when[node] = 0.;
  }
  return std::move(passing.greatest);
}

}  // namespace geneva::post
