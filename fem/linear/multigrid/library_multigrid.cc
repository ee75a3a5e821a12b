#include "fem/linear/multigrid/library_multigrid.h"

#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include "fem/linear/multigrid/condensed_entries.h"
#include "fem/linear/multigrid/coupled_nodes.h"
#include "fem/linear/multigrid/rigid_displacement.h"

namespace geneva::fem {

namespace {

template <int dim>
std::vector<dealii::Point<dim>> own_positions(const SymmetricMatrix<dim>& matrix,
                                              const dealii::DoFHandler<dim>& dof_handler) {
  const CoupledNodes<dim> nodes(matrix, dof_handler);
  return {nodes.positions().begin(),
          nodes.positions().begin() + static_cast<std::ptrdiff_t>(nodes.n_own())};
}

Epetra_Map map_of(const UnknownRanges& unknowns) {
  return {unknowns.n_all(), unknowns.n_own(), 0, Epetra_MpiComm(unknowns.communicator())};
}

/// As its manual advises for elasticity (M. Gee and others, ML 5.0 Smoothed Aggregation User's
/// Guide, 2006), with the polynomial smoother that ours has.
template <int dim>
Teuchos::ParameterList parameters(std::vector<double>& motions) {
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", dim);
  list.set("aggregation: type", "Uncoupled");
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", 2);
  list.set("coarse: type", "Amesos-KLU");
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", n_rigid_motions<dim>);
  list.set("null space: vectors", motions.data());
  return list;
}

}  // namespace

template <int dim>
LibraryMultigrid<dim>::LibraryMultigrid(const CondensedMatrix<dim>& matrix,
                                        const dealii::DoFHandler<dim>& dof_handler)
    : matrix_(matrix), positions_(own_positions(matrix.whole(), dof_handler)) {
  renew();
}

template <int dim>
void LibraryMultigrid<dim>::renew() {
  levels_.reset();
  fill_matrix();
  motions_ = rigid_motions();
  levels_ =
      std::make_unique<ML_Epetra::MultiLevelPreconditioner>(*condensed_, parameters<dim>(motions_));
}

template <int dim>
void LibraryMultigrid<dim>::fill_matrix() {
  constexpr int entries_in_row = 0;  // found out by the matrix
  condensed_ =
      std::make_unique<Epetra_FECrsMatrix>(Copy, map_of(matrix_.unknowns()), entries_in_row);
  const auto add = [&](const int row, const int column, const double value) {
    condensed_->InsertGlobalValues(1, &row, 1, &column, &value);
  };
  for (const Eigen::Triplet<double>& entry :
       condensed_entries(matrix_.whole(), matrix_.elimination())) {
    add(entry.row(), entry.col(), entry.value());
    if (entry.row() != entry.col()) add(entry.col(), entry.row(), entry.value());
  }
  condensed_->GlobalAssemble();
}

template <int dim>
std::vector<double> LibraryMultigrid<dim>::rigid_motions() const {
  const std::size_t n_unknowns = dim * positions_.size();
  std::vector<double> motions(n_rigid_motions<dim> * n_unknowns, 0.);
  for (std::size_t node = 0; node < positions_.size(); ++node) {
    const RigidDisplacement<dim> displacement = rigid_displacement(positions_[node]);
    for (int component = 0; component < dim; ++component) {
      const std::size_t unknown = dim * node + static_cast<std::size_t>(component);
      if (condensed_->NumMyEntries(static_cast<int>(unknown)) == 1) continue;
      for (int motion = 0; motion < n_rigid_motions<dim>; ++motion)
        motions[static_cast<std::size_t>(motion) * n_unknowns + unknown] =
            displacement(component, motion);
    }
  }
  return motions;
}

template <int dim>
void LibraryMultigrid<dim>::vmult(Vector& correction, const Vector& residual) const {
  // Epetra's views of values cannot be const.
  const Epetra_Vector from(View, condensed_->RowMap(), const_cast<double*>(residual.begin()));
  Epetra_Vector to(View, condensed_->RowMap(), correction.begin());
  levels_->ApplyInverse(from, to);
}

template class LibraryMultigrid<2>;
template class LibraryMultigrid<3>;

}  // namespace geneva::fem
