#pragma once

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>

#include <Sacado.hpp>
#include <array>
#include <functional>
#include <set>

#include "fem/elasticity/cell_systems.h"
#include "fem/elasticity/elasticity.h"
#include "fem/held_tractions.h"
#include "fem/stress_recovery.h"
#include "mesh/triangulation.h"

namespace geneva::test {

/// A displacement field with the stress and the body force that belong to it, in a unit of stress.
template <int dim>
struct ExactField {
  std::function<dealii::Tensor<1, dim>(const dealii::Point<dim>&)> displacement;
  std::function<fem::StressVector<dim>(const dealii::Point<dim>&)> stress;
  std::function<dealii::Tensor<1, dim>(const dealii::Point<dim>&)> force;  ///< per volume
};

template <typename Number, int dim>
using Coordinates = std::array<Number, static_cast<std::size_t>(dim)>;

/// The stresses that a displacement field makes in a material, and the force -div stress that
/// balances them, by automatic differentiation.
/// @param u calculates the displacement (an array) from coordinates (an array) of any kind of
/// number
template <int dim, typename Displacement>
ExactField<dim> manufactured(const fem::Material& material, const fem::PlaneKind plane,
                             const Displacement& u) {
  using Outer = Sacado::Fad::SFad<double, dim>;
  using Inner = Sacado::Fad::SFad<Outer, dim>;
  const bool has_hoop = dim == 2 && plane == fem::PlaneKind::axisymmetric;
  // by place i, j; [2][2] is the stress out of the plane
  const auto stresses = [=](const dealii::Point<dim>& place) {
    Coordinates<Inner, dim> x;
    for (unsigned int i = 0; i < dim; ++i)
      x[i] = Inner(dim, static_cast<int>(i), Outer(dim, static_cast<int>(i), place[i]));
    const Coordinates<Inner, dim> displaced = u(x);
    std::array<std::array<Outer, 3>, 3> strain{};
    for (auto& row : strain)
      for (Outer& entry : row) entry = 0.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        strain[i][j] =
            0.5 * (displaced[i].dx(static_cast<int>(j)) + displaced[j].dx(static_cast<int>(i)));
    if (has_hoop) strain[2][2] = displaced[0].val() / x[0].val();
    const fem::Lame lame = fem::lame(material, dim == 3 ? fem::PlaneKind::plane_strain : plane);
    const Outer dilatation = strain[0][0] + strain[1][1] + strain[2][2];
    std::array<std::array<Outer, 3>, 3> stress{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j) {
        stress[i][j] = 2. * lame.mu * strain[i][j];
        if (i == j) stress[i][j] += lame.lambda_plane * dilatation;
      }
    if (dim == 2 && plane == fem::PlaneKind::plane_stress) stress[2][2] = 0.;
    return stress;
  };
  ExactField<dim> field;
  field.displacement = [=](const dealii::Point<dim>& place) {
    Coordinates<double, dim> x;
    for (unsigned int i = 0; i < dim; ++i) x[i] = place[i];
    const Coordinates<double, dim> displaced = u(x);
    dealii::Tensor<1, dim> result;
    for (unsigned int i = 0; i < dim; ++i) result[i] = displaced[i];
    return result;
  };
  field.stress = [=](const dealii::Point<dim>& place) {
    const auto s = stresses(place);
    fem::StressVector<dim> result;
    for (unsigned int i = 0; i < 3; ++i) result[i] = s[i][i].val();
    result[3] = s[0][1].val();
    if constexpr (dim == 3) {
      result[4] = s[0][2].val();
      result[5] = s[1][2].val();
    }
    return result;
  };
  field.force = [=](const dealii::Point<dim>& place) {
    const auto s = stresses(place);
    dealii::Tensor<1, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j) result[i] -= s[i][j].dx(static_cast<int>(j));
    if (has_hoop) {
      result[0] -= (s[0][0].val() - s[2][2].val()) / place[0];
      result[1] -= s[0][1].val() / place[0];
    }
    return result;
  };
  return field;
}

/// Elastic bodies on a mesh, whose displacement is an exact field's on the surfaces that are held;
/// the others are free. On one rank.
template <int dim>
class HeldBodies {
 public:
  /// Whether a component is held at a surface.
  using IsHeld = std::function<bool(const std::string&, unsigned int)>;

  HeldBodies(dealii::parallel::distributed::Triangulation<dim>& triangulation,
             const mesh::MeshData<dim>& mesh, const fem::Problem<dim>& problem, IsHeld is_held)
      : mesh_(mesh),
        problem_(problem),
        is_held_(std::move(is_held)),
        element_(dealii::FE_Q<dim>(1), dim) {
    dof_handler_.reinit(triangulation);
    dof_handler_.distribute_dofs(element_);
  }

  void solve(const ExactField<dim>& exact) {
    dealii::AffineConstraints<double> constraints;
    dealii::DoFTools::make_hanging_node_constraints(dof_handler_, constraints);
    for (const auto& cell : dof_handler_.active_cell_iterators())
      for (const unsigned int face : cell->face_indices()) {
        if (!cell->face(face)->at_boundary()) continue;
        const std::string& surface = mesh_.surfaces[cell->face(face)->boundary_id()];
        for (const unsigned int vertex : cell->face(face)->vertex_indices())
          for (unsigned int i = 0; i < dim; ++i) {
            const auto dof = cell->face(face)->vertex_dof_index(vertex, i);
            if (!is_held_(surface, i) || constraints.is_constrained(dof)) continue;
            constraints.add_line(dof);
            constraints.set_inhomogeneity(dof,
                                          exact.displacement(cell->face(face)->vertex(vertex))[i]);
          }
      }
    constraints.close();
    dealii::DynamicSparsityPattern entries(dof_handler_.n_dofs());
    dealii::DoFTools::make_sparsity_pattern(dof_handler_, entries, constraints, false);
    dealii::SparsityPattern pattern;
    pattern.copy_from(entries);
    dealii::SparseMatrix<double> matrix(pattern);
    dealii::Vector<double> load(dof_handler_.n_dofs());
    assemble(exact, constraints, matrix, load);
    dealii::Vector<double> solution(dof_handler_.n_dofs());
    dealii::SolverControl control(20000, 1e-11 * load.l2_norm());
    dealii::PreconditionSSOR<dealii::SparseMatrix<double>> smoother;
    smoother.initialize(matrix, 1.2);
    dealii::SolverCG<dealii::Vector<double>>(control).solve(matrix, solution, load, smoother);
    constraints.distribute(solution);
    find_forces(exact, solution);
    displacement_.reinit(dof_handler_.locally_owned_dofs(), MPI_COMM_SELF);
    for (unsigned int i = 0; i < solution.size(); ++i) displacement_(i) = solution(i);
  }

  [[nodiscard]] fem::NodalStress<dim> recovered() const {
    fem::BoundaryTractions<dim> tractions =
        fem::boundary_tractions<dim>(mesh_, problem_, {1., 1.}, {});
    fem::HeldComponents<dim> held;
    for (unsigned int i = 0; i < mesh_.surfaces.size(); ++i)
      if (is_held_(mesh_.surfaces[i], 0) && is_held_(mesh_.surfaces[i], 1)) {
        tractions.surfaces[i].kind = fem::TractionKind::held;
        for (unsigned int c = 0; c < dim; ++c) held[i][c] = is_held_(mesh_.surfaces[i], c);
      }
    const fem::Boundary<dim> boundary = fem::gather_boundary(dof_handler_, mesh_.circles, 1.);
    dealii::IndexSet all(dof_handler_.n_dofs());
    all.add_range(0, dof_handler_.n_dofs());
    const auto hanging =
        fem::hanging_lines(dof_handler_, fem::hanging_nodes(dof_handler_, all), boundary);
    tractions.at_held = fem::held_tractions<dim>(
        boundary, problem_, held, hanging,
        [&](const auto dof) { return force_(static_cast<unsigned>(dof)); });
    return fem::recovered_stress(dof_handler_, displacement_, problem_, tractions);
  }

  [[nodiscard]] const dealii::DoFHandler<dim>& dof_handler() const { return dof_handler_; }
  [[nodiscard]] const fem::Vector& displacement() const { return displacement_; }

 private:
  void assemble(const ExactField<dim>& exact, const dealii::AffineConstraints<double>& constraints,
                dealii::SparseMatrix<double>& matrix, dealii::Vector<double>& load) const {
    visit_systems(exact, [&](const fem::CellSystem& system) {
      constraints.distribute_local_to_global(system.stiffness, system.load, system.dofs, matrix,
                                             load);
    });
  }

  /// K u - f, the hanging nodes' given to those that they hang on.
  void find_forces(const ExactField<dim>& exact, const dealii::Vector<double>& solution) {
    dealii::AffineConstraints<double> hanging;
    dealii::DoFTools::make_hanging_node_constraints(dof_handler_, hanging);
    hanging.close();
    force_.reinit(dof_handler_.n_dofs());
    visit_systems(exact, [&](const fem::CellSystem& system) {
      dealii::Vector<double> u(system.load.size());
      dealii::Vector<double> force(system.load.size());
      for (unsigned int i = 0; i < u.size(); ++i)
        u[i] = solution(static_cast<unsigned>(system.dofs[i]));
      system.stiffness.vmult(force, u);
      force -= system.load;
      hanging.distribute_local_to_global(force, system.dofs, force_);
    });
  }

  /// Calls visit(system) for every cell, the body force in its load.
  template <typename Visit>
  void visit_systems(const ExactField<dim>& exact, const Visit& visit) const {
    const fem::CellSystems systems = fem::cell_systems(dof_handler_, problem_, mesh_.surfaces);
    dealii::FEValues<dim> values(
        element_, dealii::QGauss<dim>(3),
        dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values);
    std::size_t index = 0;
    for (const auto& cell : dof_handler_.active_cell_iterators()) {
      fem::CellSystem system = systems[index++];
      values.reinit(cell);
      for (const unsigned int q : values.quadrature_point_indices()) {
        const auto force = exact.force(values.quadrature_point(q));
        const double measure =
            values.JxW(q) * fem::out_of_plane_measure<dim>(problem_, values.quadrature_point(q));
        for (unsigned int i = 0; i < system.load.size(); ++i)
          system.load[i] += values.shape_value(i, q) *
                            force[element_.system_to_component_index(i).first] * measure;
      }
      visit(system);
    }
  }

  mesh::MeshData<dim> mesh_;
  fem::Problem<dim> problem_;
  IsHeld is_held_;
  dealii::FESystem<dim> element_;
  dealii::DoFHandler<dim> dof_handler_;
  fem::Vector displacement_;
  dealii::Vector<double> force_;  ///< what surfaces that are held exert
};

/// Root-mean-square differences from an exact field, relative to its own root mean square.
struct FieldErrors {
  double displacement;
  double stress;             ///< in the volume
  double stress_at_surface;  ///< at the nodes of the surface asked for; 0 without any
};

template <int dim>
FieldErrors errors_of(const HeldBodies<dim>& bodies, const ExactField<dim>& exact,
                      const std::set<dealii::types::boundary_id>& surface) {
  const fem::NodalStress<dim> recovered = bodies.recovered();
  const dealii::QGauss<dim> points(3);
  const auto flags =
      dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values;
  dealii::FEValues<dim> displaced(bodies.dof_handler().get_fe(), points, flags);
  dealii::FEValues<dim> stressed(*recovered.element, points, dealii::update_values);
  std::vector<dealii::Vector<double>> u(points.size(), dealii::Vector<double>(dim));
  std::vector<dealii::Vector<double>> s(points.size(),
                                        dealii::Vector<double>(fem::n_stress_components<dim>));
  std::array<double, 6> sums{};
  auto of_stress = recovered.dof_handler->begin_active();
  for (const auto& cell : bodies.dof_handler().active_cell_iterators()) {
    displaced.reinit(cell);
    stressed.reinit(of_stress);
    displaced.get_function_values(bodies.displacement(), u);
    stressed.get_function_values(recovered.values, s);
    for (const unsigned int q : displaced.quadrature_point_indices()) {
      const dealii::Point<dim>& place = displaced.quadrature_point(q);
      const auto exact_u = exact.displacement(place);
      const auto exact_s = exact.stress(place);
      for (unsigned int i = 0; i < dim; ++i) {
        sums[0] += std::pow(u[q][i] - exact_u[i], 2) * displaced.JxW(q);
        sums[1] += std::pow(exact_u[i], 2) * displaced.JxW(q);
      }
      for (unsigned int i = 0; i < fem::n_stress_components<dim>; ++i) {
        sums[2] += std::pow(s[q][i] - exact_s[i], 2) * displaced.JxW(q);
        sums[3] += std::pow(exact_s[i], 2) * displaced.JxW(q);
      }
    }
    for (const unsigned int face : of_stress->face_indices()) {
      if (!of_stress->face(face)->at_boundary() ||
          surface.count(of_stress->face(face)->boundary_id()) == 0)
        continue;
      for (const unsigned int vertex : of_stress->face(face)->vertex_indices()) {
        const auto exact_s = exact.stress(of_stress->face(face)->vertex(vertex));
        for (unsigned int i = 0; i < fem::n_stress_components<dim>; ++i) {
          const double found = recovered.values(of_stress->face(face)->vertex_dof_index(vertex, i));
          sums[4] += std::pow(found - exact_s[i], 2);
          sums[5] += std::pow(exact_s[i], 2);
        }
      }
    }
    ++of_stress;
  }
  return {std::sqrt(sums[0] / sums[1]), std::sqrt(sums[2] / sums[3]),
          sums[5] > 0. ? std::sqrt(sums[4] / sums[5]) : 0.};
}

}  // namespace geneva::test
