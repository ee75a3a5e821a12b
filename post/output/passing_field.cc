#include "post/output/passing_field.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "loads/contact_limits.h"
#include "loads/hertz.h"

namespace geneva::post {

namespace {

/// The greatest stresses of a body over p0 along its surface, by depth over b.
class PassingStresses {
 public:
  /// @param deepest over b
  PassingStresses(const double poissons_ratio, const double friction, const double deepest)
      : nu_(poissons_ratio), friction_(friction) {
    const int count = static_cast<int>(std::ceil(std::asinh(deepest) / step)) + 1;
    for (int i = 0; i <= count; ++i) by_depth_.push_back(at_depth(std::sinh(step * i)));
  }

  /// @param depth over b, >= 0, at most the deepest
  [[nodiscard]] NodeMaxima at(const double depth) const {
    const double steps = std::asinh(depth) / step;
    const auto before = std::min(static_cast<std::size_t>(steps), by_depth_.size() - 2);
    const double share = steps - static_cast<double>(before);
    const NodeMaxima& from = by_depth_[before];
    const NodeMaxima& to = by_depth_[before + 1];
    const auto between = [&](const double a, const double b) { return a + share * (b - a); };
    return {between(from.von_mises, to.von_mises),
            between(from.first_principal, to.first_principal),
            between(from.max_shear, to.max_shear)};
  }

 private:
  static constexpr double step = 0.02;  // of depth over b, deeper down of its logarithm

  /// Beside the contact by up to twice its half-width and the depth, where all three have their
  /// maxima.
  [[nodiscard]] NodeMaxima at_depth(const double depth) const {
    constexpr int places = 200;
    const loads::HertzLine contact{1., 1., 0., 0.};
    const double reach = 2. + depth;
    NodeMaxima greatest{0., -1., 0.};
    for (int i = -places; i <= places; ++i) {
      const loads::ContactStress stress =
          loads::sliding_stress(contact, friction_, reach * i / places, depth);
      const double along = nu_ * (stress.xx + stress.zz);  // plane strain
      const double middle = 0.5 * (stress.xx + stress.zz);
      const double shear = std::hypot(0.5 * (stress.xx - stress.zz), stress.xz);
      const double first = std::max(middle + shear, along);
      const double third = std::min(middle - shear, along);
      const double von_mises = std::sqrt(3. * shear * shear + std::pow(middle - along, 2));
      greatest.von_mises = std::max(greatest.von_mises, von_mises);
      greatest.first_principal = std::max(greatest.first_principal, first);
      greatest.max_shear = std::max(greatest.max_shear, 0.5 * (first - third));
    }
    return greatest;
  }

  double nu_;
  double friction_;
  std::vector<NodeMaxima> by_depth_;
};

/// Greatest depth of a node that a contact passes, over its half-width.
double deepest(const PassingContact& passing, const double half_width_per_pressure) {
  double greatest = 0.;
  for (std::size_t node = 0; node < passing.depth.size(); ++node)
    if (const double pressure = passing.greatest.pressure[node]; pressure > 0.)
      greatest = std::max(greatest, passing.depth[node] / (half_width_per_pressure * pressure));
  return greatest;
}

}  // namespace

double missed_depth(std::vector<double> pin_distances, const double half_width) {
  std::sort(pin_distances.begin(), pin_distances.end());
  double way = 0.;
  for (std::size_t i = 0; i + 1 < pin_distances.size(); ++i)
    way = std::max(way, pin_distances[i + 1] - pin_distances[i]);
  return std::max(4. * half_width, 1.5 * way);
}

void raise_to_passing_field(Envelope& greatest, const NodalFields& fields,
                            const PassingContact& passing, const PassingMaterials& materials) {
  constexpr double most_depths = 200.;  // over b, where next to nothing is left
  const double per_pressure = materials.half_width_per_pressure;
  const double end = std::min(deepest(passing, per_pressure), most_depths);
  const std::vector<unsigned int> bodies = bodies_of_nodes(fields);
  std::map<unsigned int, PassingStresses> of_bodies;
  for (std::size_t node = 0; node < bodies.size(); ++node) {
    const double pressure = passing.greatest.pressure[node];
    if (pressure <= 0.) continue;
    const double depth = passing.depth[node] / (per_pressure * pressure);
    if (depth > end) continue;
    const auto body = of_bodies.try_emplace(bodies[node], materials.poissons_ratios[bodies[node]],
                                            materials.friction, end);
    const NodeMaxima stress = body.first->second.at(depth);
    raise(greatest, node,
          {pressure * stress.von_mises, pressure * stress.first_principal,
           pressure * stress.max_shear},
          passing.greatest.when[node]);
  }
}

}  // namespace geneva::post
