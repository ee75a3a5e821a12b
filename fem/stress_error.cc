#include "fem/stress_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/discretisation/cell_parts.h"
#include "fem/discretisation/refined_mesh.h"
#include "fem/stress_variation.h"

namespace geneva::fem {

template <int dim>
double open_by_cell(const double variation, const double measure, const double size,
                    const double distance) {
  constexpr double pi = 3.14159265358979323846;
  constexpr double factor = dim == 2 ? 1. / (6. * pi) : 1. / (16. * pi);
  return factor * variation * size * measure / std::pow(std::max(distance, size), dim + 1);
}

namespace {

/// What a cell leaves open, relative to a maximum of its body.
struct OpenByCell {
  double of_maximum;  ///< of the maximum where it is
  double of_own;      ///< of the stress in the cell, if that may be the maximum; else 0
};

template <int dim>
OpenByCell open_by(const NodalStress<dim>& stress, const OutsideOfContact<dim>& is_outside,
                   const StressCell<dim>& cell, const StressMaximum<dim>& maximum,
                   const double length) {
  // In the units of the triangulation the model's extent is 1. Farther away a figure's own field is
  // that of the body as a whole and falls no more.
  constexpr double share_of_extent = 0.1;
  const double varying = variation(stress, cell);
  const CellParts<dim> parts = parts_of<dim>(cell);
  const double size = std::pow(parts.measure, 1. / dim);
  const auto at_place = [&](const dealii::Point<dim>& place) {
    double sum = 0.;
    for (const dealii::Point<dim>& centre : parts.centres)
      sum += open_by_cell<dim>(varying, parts.measure, size,
                               std::min(place.distance(centre), share_of_extent));
    return sum / maximum.value;
  };
  dealii::Point<dim> place;
  for (unsigned int i = 0; i < dim; ++i) place[i] = maximum.place[i] / length;
  constexpr double nearly = 0.95;  // lest rounding and noise choose one of many equal places
  const bool may_be_maximum = maximum_von_mises(stress, cell) + varying >= nearly * maximum.value &&
                              is_outside(stress, cell);
  return {at_place(place), may_be_maximum ? at_place(cell->center()) : 0.};
}

/// The greatest of what a cell leaves open of its body's wanted maxima.
template <int dim>
OpenByCell open_by(const Solution<dim>& solution, const NodalStress<dim>& stress,
                   const OutsideOfContact<dim>& is_outside, const WantedMaxima<dim>& wanted,
                   const StressCell<dim>& cell) {
  OpenByCell result{0., 0.};
  for (const StressMaximum<dim>* const maximum : wanted[cell->material_id()])
    if (maximum->value > 0.) {
      const OpenByCell open = open_by(stress, is_outside, cell, *maximum, solution.scales.length);
      result.of_maximum = std::max(result.of_maximum, open.of_maximum);
      result.of_own = std::max(result.of_own, open.of_own);
    }
  return result;
}

/// The value above which numbers of all ranks make a share of their sum.
double bulk_threshold(const std::vector<double>& numbers, const double share,
                      const MPI_Comm communicator) {
  const auto sum_above = [&](const double threshold) {
    double sum = 0.;
    for (const double number : numbers)
      if (number > threshold) sum += number;
    return dealii::Utilities::MPI::sum(sum, communicator);
  };
  double low = 0.;
  double high = dealii::Utilities::MPI::max(
      numbers.empty() ? 0. : *std::max_element(numbers.begin(), numbers.end()), communicator);
  const double wanted = share * sum_above(0.);
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (sum_above(middle) >= wanted ? low : high) = middle;
  }
  return low;
}

}  // namespace

template <int dim>
double open_by_cells(const Solution<dim>& solution, const NodalStress<dim>& stress,
                     const OutsideOfContact<dim>& is_outside, const unsigned int body,
                     const StressMaximum<dim>& maximum) {
  if (maximum.value == 0.) return 0.;
  double sum = 0.;
  double of_own = 0.;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->material_id() != body) continue;
    const OpenByCell open = open_by(stress, is_outside, cell, maximum, solution.scales.length);
    sum += open.of_maximum;
    of_own = std::max(of_own, open.of_own);
  }
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  return dealii::Utilities::MPI::sum(sum, communicator) +
         dealii::Utilities::MPI::max(of_own, communicator);
}

template <int dim>
unsigned int flag_open(const Solution<dim>& solution, const NodalStress<dim>& stress,
                       const OutsideOfContact<dim>& is_outside, const WantedMaxima<dim>& wanted,
                       const std::function<bool(const StressCell<dim>&)>& may_be_finer,
                       const double bulk) {
  constexpr double matters = 0.1;
  std::vector<StressCell<dim>> cells;
  std::vector<double> of_maximum, of_own;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->level() >= deepest_level<dim> ||
        wanted[cell->material_id()].empty() || !may_be_finer(cell))
      continue;
    const OpenByCell open = open_by(solution, stress, is_outside, wanted, cell);
    cells.push_back(cell);
    of_maximum.push_back(open.of_maximum);
    of_own.push_back(open.of_own);
  }
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  const double sum = dealii::Utilities::MPI::sum(
      std::accumulate(of_maximum.begin(), of_maximum.end(), 0.), communicator);
  const double threshold = bulk_threshold(of_maximum, bulk, communicator);
  unsigned int flagged = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (of_maximum[i] > threshold || of_own[i] > matters * sum) {
      cells[i]->set_refine_flag();
      ++flagged;
    }
  return dealii::Utilities::MPI::sum(flagged, communicator);
}

template double open_by_cell<2>(double, double, double, double);
template double open_by_cell<3>(double, double, double, double);

#define INSTANTIATE(dim)                                                                  \
  template double open_by_cells(const Solution<dim>&, const NodalStress<dim>&,            \
                                const OutsideOfContact<dim>&, unsigned int,               \
                                const StressMaximum<dim>&);                               \
  template unsigned int flag_open(const Solution<dim>&, const NodalStress<dim>&,          \
                                  const OutsideOfContact<dim>&, const WantedMaxima<dim>&, \
                                  const std::function<bool(const StressCell<dim>&)>&, double);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace geneva::fem
