#include "fem/multigrid/multigrid.h"

#include <utility>

#include "fem/multigrid/coarse_matrix.h"
#include "fem/multigrid/prolongation.h"
#include "fem/multigrid/v_cycle.h"

namespace geneva::fem {

template <int dim>
Multigrid<dim>::Multigrid(const NodeMatrix<dim>& matrix, const dealii::DoFHandler<dim>& dof_handler,
                          const dealii::AffineConstraints<double>& constraints)
    : matrix_(matrix) {
  // The power method comes from below, and Chebyshev's polynomial grows fast beyond its range.
  constexpr double margin = 1.1;
  // Of the eigenvalues that are smoothed; 6 and 20 take an iteration more.
  constexpr double ratio = 10.;
  const MPI_Comm communicator = dof_handler.get_communicator();
  const double largest = margin * largest_eigenvalue(matrix, communicator);
  Prolongation<dim> prolonged =
      prolongation(CoupledNodes<dim>(matrix, dof_handler), dof_handler.locally_owned_dofs(),
                   constraints, largest);
  prolongation_.emplace(std::move(prolonged.matrix));
  coarse_ = std::make_unique<AlgebraicMultigrid<dim>>(
      CoarseProblem<dim>{coarse_matrix(matrix, *prolongation_, communicator),
                         std::move(prolonged.positions), std::move(prolonged.bodies)},
      communicator);
  coarse_zero_.reinit(dealii::IndexSet(prolongation_->pattern().unknowns()), communicator);
  smoother_ = std::make_unique<Chebyshev<dim>>(matrix, largest / ratio, margin * largest);
}

template <int dim>
void Multigrid<dim>::vmult(Vector& correction, const Vector& residual) const {
  v_cycle(matrix_, *smoother_, *prolongation_, *coarse_, coarse_zero_, correction, residual);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace geneva::fem
