#include "fem/adaptivity/pressure_error.h"

namespace geneva::fem {

template <int dim>
PressureError pressure_error(const std::vector<LevelRecord>& history,
                             const ContactTraits& contact) {
  PressureError error;
  if (dim == 3) error.edge = edge_pressure(history);
  const std::vector<MeshValue> values = resolved_values(
      history, error.is_of_peak() ? &LevelRecord::peak_pressure : &LevelRecord::mid_length_pressure,
      contact.force);
  const Extrapolation found = values.empty()
                                  ? Extrapolation{0., 1., 1.}
                                  : extrapolate(values, contact.grading, contact.convergence);
  const bool is_shown = shows_zone_error<dim>(history) && !contact.is_uneven;
  error.zone = is_shown ? error_of(found.zone_error, contact.error_by_nodes) : 1.;
  const double energy_error = history.back().energy_error;
  const double of_force = open_by_force(energy_error, contact.force);
  if (error.zone < 1.)
    error.correction = under_true_force(1. + found.correction, energy_error, contact.force) - 1.;
  const bool is_open = contact.has_free_ends && !contact.surroundings_are_fine;
  if (is_open)
    error.surroundings = error_of(found.surroundings_error, of_force);
  else {
    error.surroundings = 0.;
    error.zone = error_of(error.zone, of_force);
  }
  return error;
}

template PressureError pressure_error<2>(const std::vector<LevelRecord>&, const ContactTraits&);
template PressureError pressure_error<3>(const std::vector<LevelRecord>&, const ContactTraits&);

}  // namespace geneva::fem
