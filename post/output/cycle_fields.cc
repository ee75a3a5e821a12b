#include "post/output/cycle_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "post/output/stress_at.h"
#include "post/output/vtu_text.h"

namespace geneva::post {

using base::Dimension;
using base::OutputUnit;

namespace {

using Place = StressAt::Place;
using SixStresses = std::array<double, 6>;

/// Where a direction in the pin at one instant points at another.
Place turned(const Place& direction, const CycleFields& from, const CycleFields& to) {
  const double angle = -(to.pin_turn - from.pin_turn);
  return {std::cos(angle) * direction[0] - std::sin(angle) * direction[1],
          std::sin(angle) * direction[0] + std::cos(angle) * direction[1], direction[2]};
}

/// Where a material point of the pin at one instant is at another.
Place moved(const Place& place, const CycleFields& from, const CycleFields& to) {
  const Place arm = turned({place[0] - from.pin_distance, place[1], place[2]}, from, to);
  return {to.pin_distance + arm[0], arm[1], arm[2]};
}

NodeMaxima maxima_of(const SixStresses& stress) {
  const PrincipalRange range = principal_range(stress);
  return {von_mises(stress), range.first, 0.5 * (range.first - range.third)};
}

/// What a node is under at an instant.
struct NodeStress {
  SixStresses stress;
  NodeMaxima maxima;
};

void keep_greater(const double value, const double when, const std::size_t node,
                  std::vector<double>& values, std::vector<double>& times) {
  if (value <= values[node]) return;
  values[node] = value;
  times[node] = when;
}

/// Least stress along the direction in which the greatest tension of a node acts, at most 0.
/// @param all by instant and node
double least_tension(const std::vector<CycleFields>& instants,
                     const std::vector<std::vector<NodeStress>>& all, const std::size_t node,
                     const bool turns) {
  constexpr double round_off = 1e-9;  // where an instant has no stress, of those that have some
  const auto first = [&](const std::size_t i) { return all[i][node].maxima.first_principal; };
  const auto size = [&](const std::size_t i) {
    return std::max(all[i][node].maxima.von_mises, std::abs(first(i)));
  };
  double greatest = 0.;
  for (std::size_t i = 0; i < all.size(); ++i) greatest = std::max(greatest, size(i));
  if (greatest == 0.) return 0.;
  std::size_t at = all.size();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (size(i) < round_off * greatest) continue;
    if (at == all.size() || first(i) > first(at)) at = i;
  }
  const Place direction = direction_of_first_principal(all[at][node].stress);
  double least = 0.;
  for (std::size_t i = 0; i < all.size(); ++i)
    least = std::min(least, along(turns ? turned(direction, instants[at], instants[i]) : direction,
                                  all[i][node].stress));
  return least;
}

template <std::size_t n>
VtuArray array_of(const std::string& name, const std::vector<std::array<double, n>>& values,
                  const double factor) {
  VtuArray array{name, n, {}};
  for (const auto& value : values)
    for (const double component : value)
      array.values.push_back(static_cast<float>(factor * component));
  return array;
}

VtuArray array_of(const std::string& name, const std::vector<double>& values, const double factor) {
  VtuArray array{name, 1, {}};
  for (const double value : values) array.values.push_back(static_cast<float>(factor * value));
  return array;
}

std::string instant_text(const CycleFields& instant, const OutputUnit& length,
                         const OutputUnit& stress) {
  const NodalFields& fields = instant.fields;
  return vtu_text(fields,
                  {array_of("displacement", fields.displacements, length.factor),
                   array_of("stress", fields.stress, stress.factor),
                   array_of("von_mises", fields.von_mises, stress.factor)},
                  length.factor);
}

std::vector<VtuArray> envelope_arrays(const Envelope& greatest, const OutputUnit& stress,
                                      const SeriesOrder& order) {
  const auto when = [&](const char* const of, const std::vector<double>& values) {
    return array_of(std::string(of) + "_" + order.name, values, order.factor);
  };
  return {array_of("von_mises", greatest.von_mises, stress.factor),
          when("von_mises", greatest.von_mises_when),
          array_of("principal_stress_1", greatest.first_principal, stress.factor),
          when("principal_stress_1", greatest.first_principal_when),
          array_of("max_shear", greatest.max_shear, stress.factor),
          when("max_shear", greatest.max_shear_when),
          array_of("principal_stress_1_least", greatest.tension_least, stress.factor)};
}

/// Whether the nodes are the same material points.
bool is_of_same_mesh(const CycleFields& one, const CycleFields& other) {
  return one.pin_distance == other.pin_distance && one.pin_turn == other.pin_turn &&
         one.fields.places == other.fields.places;
}

}  // namespace

void raise(Envelope& envelope, const std::size_t node, const NodeMaxima& stress,
           const double when) {
  keep_greater(stress.von_mises, when, node, envelope.von_mises, envelope.von_mises_when);
  keep_greater(stress.first_principal, when, node, envelope.first_principal,
               envelope.first_principal_when);
  keep_greater(stress.max_shear, when, node, envelope.max_shear, envelope.max_shear_when);
}

Envelope envelope(const CycleFields& own, const std::vector<CycleFields>& instants,
                  const std::vector<bool>& turning) {
  const std::size_t n_nodes = own.fields.places.size();
  const std::vector<unsigned int> body = bodies_of_nodes(own.fields);
  const std::vector<double> least(n_nodes, std::numeric_limits<double>::lowest());
  const std::vector<double> zeros(n_nodes, 0.);
  Envelope greatest{least, zeros, least, zeros, least, zeros, zeros};
  std::vector<std::vector<NodeStress>> all;  // by instant and node
  for (const CycleFields& instant : instants) {
    const bool is_same_mesh = is_of_same_mesh(instant, own);
    std::optional<StressAt> stress_at;
    if (!is_same_mesh) stress_at.emplace(instant.fields);
    std::vector<NodeStress>& here = all.emplace_back();
    here.reserve(n_nodes);
    for (std::size_t node = 0; node < n_nodes; ++node) {
      const Place& place = own.fields.places[node];
      const SixStresses stress =
          is_same_mesh
              ? instant.fields.stress[node]
              : (*stress_at)(turning[body[node]] ? moved(place, own, instant) : place, body[node]);
      here.push_back({stress, maxima_of(stress)});
      raise(greatest, node, here.back().maxima, instant.when);
    }
  }
  for (std::size_t node = 0; node < n_nodes; ++node)
    greatest.tension_least[node] = least_tension(instants, all, node, turning[body[node]]);
  return greatest;
}

Swing swing_of(const CycleStress& tensile, const std::vector<CycleFields>& instants,
               const std::size_t at, const std::vector<bool>& turning) {
  const bool turns = turning[tensile.body_index];
  const CycleFields& own = instants[at];
  const Place direction =
      direction_of_first_principal(StressAt(own.fields)(tensile.place, tensile.body_index));
  Swing swing{tensile.body, 0., std::nullopt};
  for (const CycleFields& instant : instants) {
    const Place place = turns ? moved(tensile.place, own, instant) : tensile.place;
    const Place n = turns ? turned(direction, own, instant) : direction;
    const double stress = along(n, StressAt(instant.fields)(place, tensile.body_index));
    if (stress >= swing.least) continue;
    swing.least = stress;
    swing.driver_angle = instant.when;
  }
  return swing;
}

std::map<std::string, std::string> cycle_series(const std::vector<CycleFields>& instants,
                                                const NodalFields& own, const Envelope& greatest,
                                                const SeriesOrder& order,
                                                const std::optional<PressureEnvelope>& pressure,
                                                const base::UnitSystem units) {
  const OutputUnit length = base::output_unit(units, Dimension::length);
  const OutputUnit stress = base::output_unit(units, Dimension::stress);
  std::map<std::string, std::string> texts;
  std::string list =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const std::string name = fmt::format("{}.{}.vtu", order.files, i);
    texts[name] = instant_text(instants[i], length, stress);
    list += fmt::format("<DataSet timestep=\"{:.9g}\" part=\"0\" file=\"{}\"/>\n",
                        instants[i].when * order.factor, name);
  }
  texts[order.files + ".pvd"] = list + "</Collection>\n</VTKFile>\n";
  std::vector<VtuArray> arrays = envelope_arrays(greatest, stress, order);
  if (pressure) {
    arrays.push_back(array_of("contact_pressure", pressure->pressure, stress.factor));
    arrays.push_back(array_of("contact_pressure_" + order.name, pressure->when, order.factor));
  }
  texts[order.envelope] = vtu_text(own, arrays, length.factor);
  return texts;
}

}  // namespace geneva::post
