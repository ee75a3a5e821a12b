#include "fem/elasticity.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

Lame lame(const Material& material, const PlaneKind plane) {
  const double E = material.youngs_modulus;
  const double nu = material.poissons_ratio;
  const double lambda = nu * E / ((1. + nu) * (1. - 2. * nu));
  const double mu = E / (2. * (1. + nu));
  const double lambda_plane =
      plane == PlaneKind::plane_stress ? 2. * lambda * mu / (lambda + 2. * mu) : lambda;
  return {lambda, mu, lambda_plane};
}

dealii::SymmetricTensor<2, 3> stress(const Lame& lame,
                                     const dealii::SymmetricTensor<2, 3>& strain) {
  return lame.lambda * dealii::trace(strain) * dealii::unit_symmetric_tensor<3>() +
         2. * lame.mu * strain;
}

PlaneStress stress(const Lame& lame, const PlaneKind plane,
                   const dealii::SymmetricTensor<2, 2>& strain, const double hoop_strain) {
  const double dilatation = dealii::trace(strain) + hoop_strain;
  PlaneStress result;
  result.in_plane =
      lame.lambda_plane * dilatation * dealii::unit_symmetric_tensor<2>() + 2. * lame.mu * strain;
  result.out_of_plane = plane == PlaneKind::plane_stress
                            ? 0.
                            : lame.lambda_plane * dilatation + 2. * lame.mu * hoop_strain;
  return result;
}

template <int dim>
double out_of_plane_measure(const Problem<dim>& problem, const Point<dim>& point) {
  if (dim == 3) return 1.;
  return problem.plane == PlaneKind::axisymmetric ? 2. * dealii::numbers::PI * point[0]
                                                  : problem.thickness;
}

namespace {

/// From the z axis to x.
template <int dim>
Tensor<1, dim> radius_vector(const Point<dim>& x) {
  Tensor<1, dim> radius = x;
  if (dim == 3) radius[dim - 1] = 0.;
  return radius;
}

/// Force per volume at x of a body with the given density.
template <int dim>
Tensor<1, dim> body_force_at(const BodyForce<dim>& force, const double density,
                             const Point<dim>& x) {
  const Tensor<1, dim> radius = radius_vector(x);
  Tensor<1, dim> result = density * force.rotation.speed * force.rotation.speed * radius;
  const double euler = density * force.rotation.acceleration;
  result[0] += euler * radius[1];
  result[1] -= euler * radius[0];
  for (unsigned int component = 0; component < dim; ++component)
    result[component] += force.uniform[component];
  return result;
}

/// Densities that give every rotating body its moment of inertia on this mesh: J divided by the
/// integral of r^2.
template <int dim>
std::vector<double> densities(const dealii::DoFHandler<dim>& dof_handler,
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
          values.JxW(q) * radius_vector(values.quadrature_point(q)).norm_square() *
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
        densities_(densities(dof_handler, problem)),
        cell_values_(dof_handler.get_fe(), dealii::QGauss<dim>(dof_handler.get_fe().degree + 1),
                     dealii::update_gradients | dealii::update_JxW_values |
                         (dim == 3 ? dealii::update_default
                                   : dealii::update_values | dealii::update_quadrature_points)),
        force_values_(
            dof_handler.get_fe(), cell_values_.get_quadrature(),
            dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points),
        face_values_(dof_handler.get_fe(), dealii::QGauss<dim - 1>(dof_handler.get_fe().degree + 1),
                     dealii::update_values | dealii::update_JxW_values |
                         dealii::update_normal_vectors | dealii::update_quadrature_points),
        centre_values_(dof_handler.get_fe(), dealii::QMidpoint<dim>(),
                       dealii::update_jacobians | dealii::update_inverse_jacobians) {
    for (const Body<dim>& body : problem.bodies)
      lame_.push_back(lame(body.material, problem.plane));
    for (const SurfaceLoad<dim>& load : problem.loads)
      for (unsigned int id = 0; id < surfaces.size(); ++id)
        if (surfaces[id] == load.surface) surface_loads_.emplace(id, load);
  }

  CellSystem integrate(const Cell& cell, StiffnessStore<dim>& stored) {
    const unsigned int n_dofs = cell->get_fe().n_dofs_per_cell();
    auto stiffness = stored.take(cell);
    CellSystem system{stiffness ? std::move(*stiffness) : stiffness_of(cell),
                      dealii::Vector<double>(n_dofs),
                      std::vector<dealii::types::global_dof_index>(n_dofs)};
    cell->get_dof_indices(system.dofs);
    if (has_force(cell->material_id())) add_body_force(cell, system.load);
    if (cell->at_boundary())
      for (const auto& face : cell->face_iterators())
        if (face->at_boundary()) add_surface_loads(cell, face, system.load);
    return system;
  }

 private:
  static constexpr int n_nodes = dealii::GeometryInfo<dim>::vertices_per_cell;
  static constexpr int n_points = 1 << dim;  // Gauss
  using Weights = Eigen::Matrix<double, n_points, 1>;
  /// Gradients of scalar functions at the points, those of a function after each other.
  template <int n_functions>
  using Gradients = Eigen::Matrix<double, dim * n_functions, n_points>;
  template <int n_functions>
  using Stiffness = Eigen::Matrix<double, dim * n_functions, dim * n_functions>;

  dealii::FullMatrix<double> stiffness_of(const Cell& cell) {
    cell_values_.reinit(cell);
    const Lame& constants = lame_[cell->material_id()];
    Stiffness<n_nodes> stiffness;
    if constexpr (dim == 3) {
      centre_values_.reinit(cell);
      stiffness = with_incompatible_modes(constants);
    } else {
      stiffness =
          hooke<n_nodes>(constants.lambda_plane, constants.mu, shape_gradients(), weights());
      if (problem_.plane == PlaneKind::axisymmetric) add_hoop_stiffness(constants, stiffness);
    }
    dealii::FullMatrix<double> result(dim * n_nodes);
    for (unsigned int i = 0; i < result.m(); ++i)
      for (unsigned int j = 0; j < result.n(); ++j)
        result(i, j) = stiffness(std::max(i, j), std::min(i, j));
    return result;
  }

  [[nodiscard]] Weights weights() const {
    Weights result;
    for (const unsigned int q : cell_values_.quadrature_point_indices())
      result[q] =
          cell_values_.JxW(q) *
          (dim == 3 ? 1. : out_of_plane_measure(problem_, cell_values_.quadrature_point(q)));
    return result;
  }

  [[nodiscard]] Gradients<n_nodes> shape_gradients() const {
    Gradients<n_nodes> result;
    for (const unsigned int q : cell_values_.quadrature_point_indices())
      for (unsigned int node = 0; node < n_nodes; ++node) {
        const Tensor<1, dim> gradient = cell_values_.shape_grad(dim * node, q);
        for (unsigned int axis = 0; axis < dim; ++axis)
          result(dim * node + axis, q) = gradient[axis];
      }
    return result;
  }

  /// Stiffness of displacements by functions in each direction: where G is the integral of
  /// grad a grad b^T, that of a and b is lambda G + mu (G^T + tr G).
  template <int n_functions>
  static Stiffness<n_functions> hooke(const double lambda, const double mu,
                                      const Gradients<n_functions>& gradients,
                                      const Weights& weights) {
    using Block = Eigen::Matrix<double, dim, dim>;
    const Stiffness<n_functions> products =
        gradients * (weights.asDiagonal() * gradients.transpose());
    Stiffness<n_functions> result = lambda * products;
    for (int a = 0; a < n_functions; ++a)
      for (int b = 0; b < n_functions; ++b) {
        const Block block = products.template block<dim, dim>(dim * a, dim * b);
        result.template block<dim, dim>(dim * a, dim * b) +=
            mu * (block.transpose() + block.trace() * Block::Identity());
      }
    return result;
  }

  /// What the hoop strain u_r/r adds.
  void add_hoop_stiffness(const Lame& constants, Stiffness<n_nodes>& stiffness) const {
    Gradients<n_nodes> hoop_strains = Gradients<n_nodes>::Zero();
    for (const unsigned int q : cell_values_.quadrature_point_indices())
      for (unsigned int node = 0; node < n_nodes; ++node)
        hoop_strains(dim * node, q) =
            cell_values_.shape_value(dim * node, q) / cell_values_.quadrature_point(q)[0];
    const Eigen::Matrix<double, n_points, dim* n_nodes> weighted =
        weights().asDiagonal() * hoop_strains.transpose();
    const Stiffness<n_nodes> mixed = shape_gradients() * weighted;
    stiffness += constants.lambda_plane * (mixed + mixed.transpose()) +
                 (constants.lambda_plane + 2. * constants.mu) * (hoop_strains * weighted);
  }

  /// Incompatible modes (Taylor, Beresford and Wilson 1976), condensed in the cell: trilinear cells
  /// that are long along a bent pin would be far too stiff without them.
  [[nodiscard]] Stiffness<n_nodes> with_incompatible_modes(const Lame& constants) const {
    constexpr int n_own = dim * n_nodes;
    constexpr int n_modes = dim * dim;
    Gradients<n_nodes + dim> gradients;
    gradients << shape_gradients(), mode_gradients();
    const Stiffness<n_nodes + dim> whole =
        hooke<n_nodes + dim>(constants.lambda, constants.mu, gradients, weights());
    const Eigen::Matrix<double, n_modes, n_own> mixed =
        whole.template bottomLeftCorner<n_modes, n_own>();
    const Eigen::Matrix<double, n_modes, n_modes> modes =
        whole.template bottomRightCorner<n_modes, n_modes>();
    return whole.template topLeftCorner<n_own, n_own>() -
           mixed.transpose() * modes.llt().solve(mixed);
  }

  /// (1 - 2 xi_k) det J0/det J grad0 xi_k for each k, J0 being the Jacobian in the cell's middle:
  /// these have no mean, so that uniform stress stays exact.
  [[nodiscard]] Gradients<dim> mode_gradients() const {
    const double determinant = centre_values_.jacobian(0).determinant();
    Gradients<dim> result;
    for (const unsigned int q : cell_values_.quadrature_point_indices()) {
      const Point<dim>& xi = cell_values_.get_quadrature().point(q);
      const double ratio =
          determinant * cell_values_.get_quadrature().weight(q) / cell_values_.JxW(q);
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int axis = 0; axis < dim; ++axis)
          result(dim * k + axis, q) =
              ratio * (1. - 2. * xi[k]) * centre_values_.inverse_jacobian(0)[k][axis];
    }
    return result;
  }

  [[nodiscard]] bool has_force(const unsigned int body) const {
    return densities_[body] != 0. || problem_.bodies[body].force.uniform != Components<dim>{};
  }

  void add_body_force(const Cell& cell, dealii::Vector<double>& load) {
    const unsigned int body = cell->material_id();
    force_values_.reinit(cell);
    for (const unsigned int q : force_values_.quadrature_point_indices()) {
      const Point<dim>& x = force_values_.quadrature_point(q);
      const Tensor<1, dim> density =
          body_force_at(problem_.bodies[body].force, densities_[body], x);
      const double weight = force_values_.JxW(q) * out_of_plane_measure(problem_, x);
      for (const unsigned int i : force_values_.dof_indices())
        load[i] += weight * density[force_values_.get_fe().system_to_component_index(i).first] *
                   force_values_.shape_value(i, q);
    }
  }

  template <typename Face>
  void add_surface_loads(const Cell& cell, const Face& face, dealii::Vector<double>& load) {
    const auto [begin, end] = surface_loads_.equal_range(face->boundary_id());
    if (begin == end) return;
    face_values_.reinit(cell, face);
    for (const unsigned int q : face_values_.quadrature_point_indices()) {
      const double weight =
          face_values_.JxW(q) * out_of_plane_measure(problem_, face_values_.quadrature_point(q));
      for (auto entry = begin; entry != end; ++entry) {
        const SurfaceLoad<dim>& surface_load = entry->second;
        Tensor<1, dim> traction = -surface_load.pressure * face_values_.normal_vector(q);
        for (unsigned int component = 0; component < dim; ++component)
          traction[component] += surface_load.traction[component];
        for (const unsigned int i : face_values_.dof_indices())
          load[i] += weight * traction[face_values_.get_fe().system_to_component_index(i).first] *
                     face_values_.shape_value(i, q);
      }
    }
  }

  const Problem<dim>& problem_;
  std::vector<double> densities_;  ///< by body
  dealii::FEValues<dim> cell_values_;
  dealii::FEValues<dim> force_values_;
  dealii::FEFaceValues<dim> face_values_;
  dealii::FEValues<dim> centre_values_;
  std::vector<Lame> lame_;
  std::multimap<unsigned int, SurfaceLoad<dim>> surface_loads_;
};

}  // namespace

template <int dim>
std::vector<CellSystem> cell_systems(const dealii::DoFHandler<dim>& dof_handler,
                                     const Problem<dim>& problem,
                                     const std::vector<std::string>& surfaces,
                                     StiffnessStore<dim> stored) {
  CellIntegrator<dim> integrator(dof_handler, problem, surfaces);
  std::vector<CellSystem> systems;
  systems.reserve(dof_handler.get_triangulation().n_active_cells());
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned()) systems.push_back(integrator.integrate(cell, stored));
  return systems;
}

template <int dim>
StiffnessStore<dim> stored_stiffness(const dealii::DoFHandler<dim>& dof_handler,
                                     std::vector<CellSystem> systems) {
  StiffnessStore<dim> stored;
  auto system = systems.begin();
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned()) stored.keep(cell, std::move((system++)->stiffness));
  return stored;
}

template double out_of_plane_measure(const Problem<2>&, const Point<2>&);
template std::vector<CellSystem> cell_systems(const dealii::DoFHandler<2>&, const Problem<2>&,
                                              const std::vector<std::string>&, StiffnessStore<2>);
template StiffnessStore<2> stored_stiffness(const dealii::DoFHandler<2>&, std::vector<CellSystem>);
template double out_of_plane_measure(const Problem<3>&, const Point<3>&);
template std::vector<CellSystem> cell_systems(const dealii::DoFHandler<3>&, const Problem<3>&,
                                              const std::vector<std::string>&, StiffnessStore<3>);
template StiffnessStore<3> stored_stiffness(const dealii::DoFHandler<3>&, std::vector<CellSystem>);

}  // namespace geneva::fem
