#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>

namespace geneva::fem {

/// Smoothed aggregation that reproduces the rigid-body modes of each body (Vanek, Mandel and
/// Brezina 1996), with the aggregates of aggregate().
/// @param matrix condensed stiffness; must outlive the multigrid
/// @param constraints by which it is condensed
template <int dim>
std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> multigrid(
    const dealii::TrilinosWrappers::SparseMatrix& matrix,
    const dealii::DoFHandler<dim>& dof_handler,
    const dealii::AffineConstraints<double>& constraints);

}  // namespace geneva::fem
