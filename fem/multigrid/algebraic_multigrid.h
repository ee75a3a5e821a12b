#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <deal.II/lac/trilinos_precondition.h>  // needs trilinos_vector.h before itself

#include <memory>
#include <vector>

namespace geneva::fem {

/// Smoothed aggregation (Vanek, Mandel and Brezina 1996) with the aggregates of aggregate().
/// @param matrix symmetric and positive definite; must outlive the result
/// @param unknowns_per_node
/// @param rigid_motions that the coarse unknowns are to reproduce, as many as a node has unknowns:
/// their values at this rank's unknowns, one after the other
/// @param bodies of this rank's nodes
std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> algebraic_multigrid(
    const Epetra_RowMatrix& matrix, int unknowns_per_node, std::vector<double> rigid_motions,
    std::vector<unsigned int> bodies);

}  // namespace geneva::fem
