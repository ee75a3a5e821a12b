#include "api/cycle_envelope.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "api/mechanism_picture.h"
#include "fem/discretisation/gather.h"
#include "model/mechanism_state.h"
#include "post/output/passing_field.h"
#include "post/output/passing_mesh.h"
#include "post/output/passing_pressure.h"

namespace geneva::api {

namespace {

/// All but the wheel move with the pin.
std::vector<bool> bodies_that_turn(const post::NodalFields& fields) {
  unsigned int last = 0;
  for (const unsigned int body : fields.bodies) last = std::max(last, body);
  std::vector<bool> turning(last + 1, true);
  turning.front() = false;
  return turning;
}

/// Of a pin on a block of wall those instants that have the block on the same side, the ones of the
/// same wall; nothing of a whole wheel, whose instants all stand beside each other.
std::optional<std::vector<post::CycleFields>> of_same_block(
    const std::vector<post::CycleFields>& fields, const post::CycleFields& at,
    const std::vector<post::CyclePoint>& points, const Case& given) {
  if (!given.mechanism->is_local) return std::nullopt;
  const auto wall_of = [&](const post::CycleFields& one) {
    return std::find_if(points.begin(), points.end(),
                        [&](const post::CyclePoint& point) {
                          return point.instant.load.driver_angle == one.when;
                        })
        ->instant.load.wall;
  };
  std::vector<post::CycleFields> of_wall;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(of_wall),
               [&](const post::CycleFields& one) { return wall_of(one) == wall_of(at); });
  return of_wall;
}

/// See post::missed_depth(), of both walls.
double missed_depth_of(const post::CycleReport& report, const double half_width) {
  double depth = 0.;
  for (const loads::Wall wall : {loads::Wall::driving, loads::Wall::braking}) {
    std::vector<double> distances;
    for (const post::CyclePoint& point : report.points)
      if (point.contact && point.instant.load.wall == wall)
        distances.push_back(point.instant.load.pin_distance);
    depth = std::max(depth, post::missed_depth(std::move(distances), half_width));
  }
  return depth;
}

/// Of pin and wall.
post::PassingMaterials passing_materials(const model::MechanismCase& mechanism,
                                         const std::size_t n_bodies) {
  const model::MechanismDynamics dynamics = model::mechanism_dynamics(mechanism);
  const loads::PinContact contact = pin_contact(mechanism, dynamics.sizes);
  post::PassingMaterials materials{contact.pin_diameter / contact.contact_modulus,
                                   dynamics.train.roller ? 0. : dynamics.train.slot_friction,
                                   std::vector<double>(n_bodies, mechanism.pin.poissons_ratio)};
  materials.poissons_ratios.front() = mechanism.wheel.poissons_ratio;
  return materials;
}

double greatest_of(const std::vector<post::CycleCurvePoint>& curve) {
  double greatest = 0.;
  for (const post::CycleCurvePoint& point : curve)
    if (std::isfinite(point.peak_pressure)) greatest = std::max(greatest, point.peak_pressure);
  return greatest;
}

/// The instant with the greatest pressure, on all ranks; none if it was not solved.
/// @param fields on rank 0
std::optional<post::CycleFields> with_greatest_pressure(
    const MPI_Comm communicator, const post::CycleReport& report,
    const std::vector<post::CycleFields>& fields) {
  const post::CyclePoint* const greatest = post::greatest_pressure(report);
  if (greatest == nullptr) return std::nullopt;
  const auto at = std::find_if(fields.begin(), fields.end(), [&](const post::CycleFields& one) {
    return one.when == greatest->instant.load.driver_angle;
  });
  std::vector<post::CycleFields> found;
  if (at != fields.end()) found.push_back(*at);
  found = dealii::Utilities::MPI::broadcast(communicator, found, 0);
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

/// A rank's share: every so many blocks of neighbours, since the nodes of a body differ in cost.
std::vector<std::size_t> share_of_nodes(const std::size_t nodes, const std::size_t rank,
                                        const std::size_t ranks) {
  constexpr std::size_t block = 64;
  std::vector<std::size_t> share;
  for (std::size_t first = rank * block; first < nodes; first += ranks * block)
    for (std::size_t node = first; node < std::min(nodes, first + block); ++node)
      share.push_back(node);
  return share;
}

/// Values of all ranks' shares in the order of the nodes, on rank 0.
std::vector<double> in_node_order(const MPI_Comm communicator, const std::vector<double>& own,
                                  const std::size_t nodes) {
  const std::vector<double> all = fem::gathered_on_first(communicator, own);
  if (all.empty()) return {};
  const std::size_t ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  std::vector<double> values(nodes);
  auto value = all.begin();
  for (std::size_t rank = 0; rank < ranks; ++rank)
    for (const std::size_t node : share_of_nodes(nodes, rank, ranks)) values[node] = *value++;
  return values;
}

/// The envelope at all nodes of an instant, on rank 0: every rank finds it at nodes of its own, and
/// has of the other instants one at a time.
/// @param fields on rank 0
post::Envelope shared_envelope(const MPI_Comm communicator, const post::CycleFields& own,
                               const std::vector<bool>& turning,
                               const std::vector<post::CycleFields>& fields) {
  using namespace dealii::Utilities::MPI;
  const std::size_t rank = this_mpi_process(communicator);
  const std::size_t ranks = n_mpi_processes(communicator);
  const std::size_t nodes = own.fields.places.size();
  post::EnvelopeOfNodes found(own, turning, share_of_nodes(nodes, rank, ranks));
  const std::size_t instants = broadcast(communicator, fields.size(), 0);
  for (std::size_t i = 0; i < instants; ++i) {
    if (ranks == 1)
      found.add(fields[i]);
    else
      found.add(broadcast(communicator, rank == 0 ? fields[i] : post::CycleFields{}, 0));
  }
  post::Envelope greatest = std::move(found).result();
  for (std::vector<double>* const values :
       {&greatest.von_mises, &greatest.von_mises_when, &greatest.first_principal,
        &greatest.first_principal_when, &greatest.max_shear, &greatest.max_shear_when,
        &greatest.tension_least})
    *values = in_node_order(communicator, *values, nodes);
  return greatest;
}

/// Of a whole wheel in the plane, with what passes between the instants, on a mesh that shows it.
CycleEnvelope with_passing_contact(const MPI_Comm communicator, const Case& given,
                                   const post::CycleReport& report,
                                   const std::vector<bool>& turning, const post::CycleFields& at,
                                   const std::vector<post::CycleFields>& fields) {
  const post::PassingMaterials materials = passing_materials(*given.mechanism, turning.size());
  const double per_pressure = materials.half_width_per_pressure;
  const double reach = missed_depth_of(report, per_pressure * greatest_of(report.curve));
  post::CycleFields fine =
      post::divided_where_passed(at, turning, report.curve, per_pressure, reach);
  post::Envelope greatest = shared_envelope(communicator, fine, turning, fields);
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0) return {};
  post::PassingContact passing = post::passing_contact(fine, turning, report.curve, reach);
  post::raise_to_passing_field(greatest, fine.fields, passing, materials);
  return {std::move(fine.fields), std::move(greatest), post::surface_pressure(std::move(passing))};
}

}  // namespace

std::vector<post::Swing> swings_of(const MPI_Comm communicator, const Case& given,
                                   const post::CycleReport& report,
                                   const std::vector<post::CycleFields>& fields) {
  std::vector<post::Swing> swings;
  const auto is_at = [](const post::CycleStressRange& range) {
    return [&](const post::CycleFields& one) { return one.when == range.driver_angle; };
  };
  for (const post::CycleStressRange& range : post::stress_ranges(report)) {
    const auto at = std::find_if(fields.begin(), fields.end(), is_at(range));
    if (range.greatest.name != "tensile stress" || at == fields.end()) continue;
    const auto of_block = of_same_block(fields, *at, report.points, given);
    const std::vector<post::CycleFields>& others = of_block ? *of_block : fields;
    const auto own = std::find_if(others.begin(), others.end(), is_at(range));
    swings.push_back(post::swing_of(range.greatest, others,
                                    static_cast<std::size_t>(own - others.begin()),
                                    bodies_that_turn(at->fields)));
  }
  return dealii::Utilities::MPI::broadcast(communicator, swings, 0);
}

std::optional<CycleEnvelope> cycle_envelope(const MPI_Comm communicator, const Case& given,
                                            const post::CycleReport& report,
                                            const std::vector<post::CycleFields>& fields) {
  const std::optional<post::CycleFields> at = with_greatest_pressure(communicator, report, fields);
  if (!at) return std::nullopt;
  const std::vector<bool> turning = bodies_that_turn(at->fields);
  if (given.dimension == 2 && !given.mechanism->is_local && !report.curve.empty())
    return with_passing_contact(communicator, given, report, turning, *at, fields);
  const auto of_block = of_same_block(fields, *at, report.points, given);
  post::Envelope greatest =
      shared_envelope(communicator, *at, turning, of_block ? *of_block : fields);
  return CycleEnvelope{at->fields, std::move(greatest), std::nullopt};
}

}  // namespace geneva::api
