#include "fem/cell_systems.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "fem/elasticity.h"

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

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

  dealii::FullMatrix<double> stiffness(const Cell& cell) {
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

  dealii::Vector<double> load(const Cell& cell) {
    dealii::Vector<double> load(dim * n_nodes);
    if (has_force(cell->material_id())) add_body_force(cell, load);
    if (cell->at_boundary())
      for (const auto& face : cell->face_iterators())
        if (face->at_boundary()) add_surface_loads(cell, face, load);
    return load;
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

  Problem<dim> problem_;
  std::vector<double> densities_;  ///< by body
  dealii::FEValues<dim> cell_values_;
  dealii::FEValues<dim> force_values_;
  dealii::FEFaceValues<dim> face_values_;
  dealii::FEValues<dim> centre_values_;
  std::vector<Lame> lame_;
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
