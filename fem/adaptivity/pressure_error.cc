#include "fem/adaptivity/pressure_error.h"

namespace geneva::fem {

template <int dim>
PressureError pressure_error(const std::vector<LevelRecord>& history,
                             const ContactTraits& contact) {
  PressureError error;
  if (dim == 3) error.edge = edge_pressure(history);
  const std::vector<MeshValue> values =
      resolved_values(history, error.is_of_peak() ? &LevelRecord::peak_pressure
                                                  : &LevelRecord::mid_length_pressure);
  const Extrapolation found = values.empty()
                                  ? Extrapolation{0., 1., 1.}
                                  : extrapolate(values, contact.grading, contact.convergence);
  const bool is_shown = shows_zone_error<dim>(history) && !contact.is_uneven;
  error.zone = is_shown ? error_of(found.zone_error, contact.error_by_nodes) : 1.;
  if (error.zone < 1.) error.correction = found.correction;
  const bool is_open = contact.has_free_ends && !contact.surroundings_are_fine;
  error.surroundings = is_open ? found.surroundings_error : 0.;
  return error;
}

template PressureError pressure_error<2>(const std::vector<LevelRecord>&, const ContactTraits&);
template PressureError pressure_error<3>(const std::vector<LevelRecord>&, const ContactTraits&);

}  // namespace geneva::fem
