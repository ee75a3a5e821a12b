#include "fem/elasticity/cell_systems.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "fem/discretisation/round_cell.h"
#include "fem/elasticity/cell_element.h"
#include "fem/elasticity/elasticity.h"
#include "fem/elasticity/sliver.h"

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

template <int dim>
Tensor<1, dim> vector_of(const Components<dim>& components) {
  Tensor<1, dim> result;
  for (unsigned int i = 0; i < dim; ++i) result[i] = components[i];
  return result;
}

/// From the z axis to x.
template <int dim>
Tensor<1, dim> from_z_axis(const Point<dim>& x) {
  Tensor<1, dim> radius = x;
  if (dim == 3) radius[dim - 1] = 0.;
  return radius;
}

/// From the axis of a body's spin to x.
template <int dim>
Tensor<1, dim> spin_radius(const PlaneKind plane, const Point<dim>& x) {
  Tensor<1, dim> radius = from_z_axis(x);
  if (dim == 2 && plane == PlaneKind::axisymmetric) radius[1] = 0.;
  return radius;
}

/// Force per volume that is the same throughout a body.
template <int dim>
Tensor<1, dim> uniform_force(const Body<dim>& body) {
  Tensor<1, dim> result;
  for (unsigned int component = 0; component < dim; ++component)
    result[component] =
        body.force.uniform[component] + body.density * body.force.acceleration[component];
  return result;
}

/// Force per volume at x.
/// @param turning_density rho of the body's rotation, see there
template <int dim>
Tensor<1, dim> body_force_at(const Body<dim>& body, const PlaneKind plane,
                             const double turning_density, const Point<dim>& x) {
  const Rotation& rotation = body.force.rotation;
  const Tensor<1, dim> radius = from_z_axis(x);
  Tensor<1, dim> result = turning_density * rotation.speed * rotation.speed * radius;
  const double euler = turning_density * rotation.acceleration;
  result[0] += euler * radius[1];
  result[1] -= euler * radius[0];
  result += body.density * body.force.spin * body.force.spin * spin_radius(plane, x);
  return result + uniform_force(body);
}

/// Densities that give every rotating body its moment of inertia on this mesh: J divided by the
/// integral of r^2.
template <int dim>
std::vector<double> turning_densities(const dealii::DoFHandler<dim>& dof_handler,
                                      const Problem<dim>& problem) {
  std::vector<double> densities(problem.bodies.size(), 0.);
  const bool has_rotation =
      std::any_of(problem.bodies.begin(), problem.bodies.end(),
                  [](const Body<dim>& body) { return body.force.rotation.inertia > 0.; });
  if (!has_rotation) return densities;
  std::vector<double> polar_moments(problem.bodies.size(), 0.);
  dealii::FEValues<dim> values(dof_handler.get_fe(), dealii::QGauss<dim>(3),
                               dealii::update_JxW_values | dealii::update_quadrature_points);
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices())
      polar_moments[cell->material_id()] +=
          values.JxW(q) * from_z_axis(values.quadrature_point(q)).norm_square() *
          out_of_plane_measure(problem, values.quadrature_point(q));
  }
  dealii::Utilities::MPI::sum(polar_moments, dof_handler.get_communicator(), polar_moments);
  for (std::size_t body = 0; body < densities.size(); ++body)
    densities[body] = problem.bodies[body].force.rotation.inertia / polar_moments[body];
  return densities;
}

/// Integrates the cells of one mesh; holds the evaluation objects, which are expensive to make.
template <int dim>
class CellIntegrator {
 public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  CellIntegrator(const dealii::DoFHandler<dim>& dof_handler, const Problem<dim>& problem,
                 const std::vector<std::string>& surfaces)
      : problem_(problem),
        turning_densities_(turning_densities(dof_handler, problem)),
        element_(problem),
        slivers_(problem),
        force_values_(
            dof_handler.get_fe(), dealii::QGauss<dim>(dof_handler.get_fe().degree + 1),
            dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points),
        face_values_(dof_handler.get_fe(), dealii::QGauss<dim - 1>(dof_handler.get_fe().degree + 1),
                     dealii::update_values | dealii::update_JxW_values |
                         dealii::update_normal_vectors | dealii::update_quadrature_points) {
    for (const SurfaceLoad<dim>& load : problem.loads)
      for (unsigned int id = 0; id < surfaces.size(); ++id)
        if (surfaces[id] == load.surface) surface_loads_.emplace(id, load);
  }

  dealii::FullMatrix<double> stiffness(const Cell& cell) {
    dealii::FullMatrix<double> stiffness = element_.stiffness(cell);
    if (cell->at_boundary()) slivers_.add_stiffness(cell, stiffness);
    return stiffness;
  }

  dealii::Vector<double> load(const Cell& cell) {
    dealii::Vector<double> load(dim * n_nodes);
    if (has_force(cell->material_id())) add_body_force(cell, load);
    if (cell->at_boundary())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary()) add_surface_loads(cell, face, load);
    return load;
  }

 private:
  static constexpr int n_nodes = dealii::GeometryInfo<dim>::vertices_per_cell;

  [[nodiscard]] bool has_force(const unsigned int body) const {
    return turning_densities_[body] != 0. || problem_.bodies[body].force.spin != 0. ||
           uniform_force(problem_.bodies[body]).norm() > 0.;
  }

  void add_body_force(const Cell& cell, dealii::Vector<double>& load) {
    const unsigned int body = cell->material_id();
    force_values_.reinit(cell);
    for (const unsigned int q : force_values_.quadrature_point_indices()) {
      const Point<dim>& x = force_values_.quadrature_point(q);
      const Tensor<1, dim> density =
          body_force_at(problem_.bodies[body], problem_.plane, turning_densities_[body], x);
      const double weight = force_values_.JxW(q) * out_of_plane_measure(problem_, x);
      for (const unsigned int i : force_values_.dof_indices())
        load[i] += weight * density[force_values_.get_fe().system_to_component_index(i).first] *
                   force_values_.shape_value(i, q);
    }
  }

  void add_surface_loads(const Cell& cell, const unsigned int face, dealii::Vector<double>& load) {
    const auto [begin, end] = surface_loads_.equal_range(cell->face(face)->boundary_id());
    if (begin == end) return;
    if (is_round(cell->face(face)))
      for (auto entry = begin; entry != end; ++entry)
        slivers_.add_load(cell, face, entry->second.pressure,
                          vector_of<dim>(entry->second.traction), load);
    face_values_.reinit(cell, face);
    for (const unsigned int q : face_values_.quadrature_point_indices()) {
      const double weight =
          face_values_.JxW(q) * out_of_plane_measure(problem_, face_values_.quadrature_point(q));
      for (auto entry = begin; entry != end; ++entry) {
        const SurfaceLoad<dim>& surface_load = entry->second;
        const Tensor<1, dim> traction = vector_of<dim>(surface_load.traction) -
                                        surface_load.pressure * face_values_.normal_vector(q);
        for (const unsigned int i : face_values_.dof_indices())
          load[i] += weight * traction[face_values_.get_fe().system_to_component_index(i).first] *
                     face_values_.shape_value(i, q);
      }
    }
  }

  Problem<dim> problem_;
  std::vector<double> turning_densities_;  ///< by body
  CellElement<dim> element_;
  Slivers<dim> slivers_;
  dealii::FEValues<dim> force_values_;
  dealii::FEFaceValues<dim> face_values_;
  std::multimap<unsigned int, SurfaceLoad<dim>> surface_loads_;
};

template <int dim>
CellSystems integrated_when_asked_for(const dealii::DoFHandler<dim>& dof_handler,
                                      const Problem<dim>& problem,
                                      const std::vector<std::string>& surfaces) {
  std::vector<typename CellIntegrator<dim>::Cell> cells;
  std::vector<CellSystems::Dofs> dofs;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cells.push_back(cell);
    dofs.emplace_back(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(dofs.back());
  }
  const auto integrator = std::make_shared<CellIntegrator<dim>>(dof_handler, problem, surfaces);
  const auto shared_cells = std::make_shared<decltype(cells)>(std::move(cells));
  return {std::move(dofs),
          [integrator, shared_cells](const std::size_t i) {
            return integrator->stiffness((*shared_cells)[i]);
          },
          [integrator, shared_cells](const std::size_t i) {
            return integrator->load((*shared_cells)[i]);
          }};
}

}  // namespace

CellSystems::CellSystems(std::vector<Dofs> dofs,
                         std::function<dealii::FullMatrix<double>(std::size_t)> stiffness,
                         std::function<dealii::Vector<double>(std::size_t)> load)
    : dofs_(std::move(dofs)), stiffness_(std::move(stiffness)), load_(std::move(load)) {}

template <int dim>
CellSystems cell_systems(const dealii::DoFHandler<dim>& dof_handler, const Problem<dim>& problem,
                         const std::vector<std::string>& surfaces) {
  return integrated_when_asked_for(dof_handler, problem, surfaces);
}

template CellSystems cell_systems(const dealii::DoFHandler<2>&, const Problem<2>&,
                                  const std::vector<std::string>&);
template CellSystems cell_systems(const dealii::DoFHandler<3>&, const Problem<3>&,
                                  const std::vector<std::string>&);

}  // namespace geneva::fem
