#include "fem/outside_of_contact.h"

#include <algorithm>

#include "fem/discretisation/round_cell.h"
#include "fem/stress_variation.h"

namespace geneva::fem {

using dealii::Point;

template <int dim>
OutsideOfContact<dim>::OutsideOfContact(const Solution<dim>& solution,
                                        const std::vector<SingularPlace<dim>>& singular)
    : own_field_(solution), length_(solution.scales.length), singular_(singular) {}

template <int dim>
bool OutsideOfContact<dim>::operator()(const Point<dim>& place, const unsigned int body,
                                       const double von_mises, const double share) const {
  return own_field_.von_mises(place, body) < share * von_mises && !is_beside(singular_, place);
}

template <int dim>
bool OutsideOfContact<dim>::operator()(const NodalStress<dim>& stress,
                                       const StressCell<dim>& cell) const {
  return (*this)(Point<dim>(cell->center() * length_), cell->material_id(),
                 maximum_von_mises(stress, cell), OwnFieldShare::usual);
}

template <int dim>
double maximum_variation(const NodalStress<dim>& stress, const OutsideOfContact<dim>& is_outside,
                         const unsigned int body) {
  double maximum = 0.;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->material_id() != body) continue;
    const double varying = variation(stress, cell);
    if (varying > maximum && is_outside(stress, cell)) maximum = varying;
  }
  return dealii::Utilities::MPI::max(maximum, stress.dof_handler->get_communicator());
}

namespace {

template <int dim>
bool is_held(const Solution<dim>& solution, const unsigned int surface) {
  const auto is_named = [&](const auto& holding) {
    return holding.surface == solution.mesh.surfaces[surface];
  };
  const auto& supports = solution.problem.supports;
  const auto& ties = solution.problem.ties;
  return std::any_of(supports.begin(), supports.end(), is_named) ||
         std::any_of(ties.begin(), ties.end(), is_named);
}

}  // namespace

template <int dim>
bool may_hide_maximum([[maybe_unused]] const Solution<dim>& solution, const StressCell<dim>& cell) {
  constexpr double most = 0.5;
  constexpr double slack = 1e-3;
  if constexpr (dim == 3) {
    const auto faces = cell->face_indices();
    return cell->at_boundary() && std::any_of(faces.begin(), faces.end(), [&](const auto face) {
             return is_round(cell->face(face)) &&
                    length_over_notch_radius(cell, face) > (1. + slack) * most &&
                    !is_held(solution, cell->face(face)->boundary_id());
           });
  }
  return false;  // chords of rounds are short in the plane
}

#define INSTANTIATE(dim)                                                                   \
  template class OutsideOfContact<dim>;                                                    \
  template double maximum_variation(const NodalStress<dim>&, const OutsideOfContact<dim>&, \
                                    unsigned int);                                         \
  template bool may_hide_maximum(const Solution<dim>&, const StressCell<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace geneva::fem
