#include "fem/adaptivity/force_error.h"

#include <cmath>

namespace geneva::fem {

ForcePower force_of_peak(const ContactShape& contact) {
  if (!contact.has_free_ends) return {1., 0.};
  if (contact.peaks_beside_end) return {0.75, 0.25};
  return {contact.is_on_axis ? 1. / 3. : 1. / 2., 0.};
}

double under_true_force(const double value, const double energy_error, const ForcePower& force) {
  return value / std::pow(1. + force_excess(energy_error), force.power);
}

double open_by_force(const double energy_error, const ForcePower& force) {
  return force.power * force_doubt(energy_error) + force.doubt * force_excess(energy_error);
}

}  // namespace geneva::fem
