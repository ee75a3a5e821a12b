#include "fem/elasticity/material_history.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

#include "fem/elasticity/cell_element.h"

namespace geneva::fem {

template <int dim>
PointValues remembered(const dealii::DoFHandler<dim>& dof_handler, const Problem<dim>& problem,
                       const MaterialLaws<dim>& laws, const Vector& displacement,
                       const PointValues& before) {
  const auto remembers = [](const auto& law) { return law->remembers(); };
  if (std::none_of(laws.begin(), laws.end(), remembers)) return {};
  const CellElement<dim> element(problem);
  const auto points = reference_points<dim>(dealii::QGauss<dim>(2));
  dealii::Vector<double> of_cell(CellElement<dim>::n_own);
  PointValues result(dof_handler.get_triangulation().n_active_cells());
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned() || !remembers(laws[cell->material_id()])) continue;
    const std::size_t index = cell->active_cell_index();
    cell->get_dof_values(displacement, of_cell);
    for (const StressVector<dim>& strain : element.strains(cell, of_cell, points)) {
      const MaterialHistory before_here =
          before.empty() ? MaterialHistory{} : before[index][result[index].size()];
      result[index].push_back(laws[cell->material_id()]->respond(strain, before_here).history);
    }
  }
  return result;
}

template PointValues remembered(const dealii::DoFHandler<2>&, const Problem<2>&,
                                const MaterialLaws<2>&, const Vector&, const PointValues&);
template PointValues remembered(const dealii::DoFHandler<3>&, const Problem<3>&,
                                const MaterialLaws<3>&, const Vector&, const PointValues&);

}  // namespace geneva::fem
