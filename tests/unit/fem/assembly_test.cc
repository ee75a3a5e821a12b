#include "fem/linear/assembly.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_Vector.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "fem/discretisation/boundary.h"
#include "fem/linear/constraints.h"
#include "mesh/extrusion.h"
#include "tests/unit/fem/discretisation.h"

namespace geneva::fem::test {
namespace {

using geneva::test::equal_steps;
using Matrix = dealii::TrilinosWrappers::SparseMatrix;

/// A block with hanging nodes, held at its bottom, whose top is pulled and tied to its side.
class TiedBlock {
 public:
  TiedBlock() {
    refine_in_part();
    dealii::DoFTools::extract_locally_relevant_dofs(*grid_.dof_handler, ghosts_);
    const Boundary<3> boundary = gather_boundary(*grid_.dof_handler, mesh_.circles, 1.);
    for (const BoundaryNode<3>& node : boundary.nodes)
      ghosts_.add_indices(node.dofs.begin(), node.dofs.end());
    auto lines =
        hanging_lines(*grid_.dof_handler, hanging_nodes(*grid_.dof_handler, ghosts_), boundary);
    const auto supports = support_lines<3>(boundary, {{"bottom", {0., 0.1, 0.}}}, mesh_.surfaces);
    lines.insert(lines.end(), supports.begin(), supports.end());
    const auto ties = tie_lines<3>(boundary, {"top", {0.6, 0.8, 0.}, 0.}, mesh_.surfaces);
    lines.insert(lines.end(), ties.lines.begin(), ties.lines.end());
    constraints_ = make_constraints(hanging_nodes(*grid_.dof_handler, ghosts_), lines);
    Problem<3> problem;
    problem.bodies.push_back({"block", {2., 0.3}, {}});
    problem.loads.push_back({"side", 0., {0.1, 0.2, 0.3}});
    cells_ = cell_systems(*grid_.dof_handler, problem, mesh_.surfaces);
  }

  /// @param load out
  [[nodiscard]] SymmetricMatrix<3> assembled(Vector& load) const {
    load = zero();
    SymmetricMatrix<3> matrix = assemble<3>(cells_, constraints_, owned(), MPI_COMM_WORLD, load);
    load.compress(dealii::VectorOperation::add);
    return matrix;
  }

  /// As the library assembles it, entry by entry.
  /// @param load out
  [[nodiscard]] std::unique_ptr<Matrix> expected(Vector& load) const {
    dealii::TrilinosWrappers::SparsityPattern pattern(owned(), owned(), ghosts_, MPI_COMM_WORLD);
    dealii::DoFTools::make_sparsity_pattern(*grid_.dof_handler, pattern, constraints_, false);
    pattern.compress();
    auto matrix = std::make_unique<Matrix>(pattern);
    load = zero();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const CellSystem cell = cells_[i];
      constraints_.distribute_local_to_global(cell.stiffness, cell.load, cell.dofs, *matrix, load);
    }
    matrix->compress(dealii::VectorOperation::add);
    load.compress(dealii::VectorOperation::add);
    return matrix;
  }

  /// Values that look random at free unknowns, zero at others.
  [[nodiscard]] Vector some_vector(const double seed) const {
    Vector result(owned(), MPI_COMM_WORLD);
    for (const auto i : owned())
      if (!constraints_.is_constrained(i))
        result(i) = std::sin(seed * (1. + static_cast<double>(i)));
    result.compress(dealii::VectorOperation::insert);
    return result;
  }

  [[nodiscard]] const dealii::IndexSet& owned() const {
    return grid_.dof_handler->locally_owned_dofs();
  }
  [[nodiscard]] const dealii::AffineConstraints<double>& constraints() const {
    return constraints_;
  }

 private:
  static mesh::MeshData<3> block() {
    mesh::MeshData<2> plane = geneva::test::empty_mesh();
    geneva::test::add_rectangle(plane, "block", equal_steps(0., 5., 5), equal_steps(0., 4., 4),
                                {"bottom", "side", "top", ""});
    return extruded(plane, {{equal_steps(0., 6., 3), "", ""}});
  }

  void refine_in_part() {
    for (const auto& cell : grid_.dof_handler->active_cell_iterators())
      if (cell->is_locally_owned() && cell->center()[0] + cell->center()[2] < 4.)
        cell->set_refine_flag();
    grid_.triangulation->execute_coarsening_and_refinement();
    grid_.dof_handler->distribute_dofs(grid_.element);
  }

  [[nodiscard]] Vector zero() const { return {owned(), ghosts_, MPI_COMM_WORLD}; }

  mesh::MeshData<3> mesh_ = block();
  Discretisation<3> grid_{mesh_};
  dealii::IndexSet ghosts_;
  dealii::AffineConstraints<double> constraints_;
  CellSystems cells_;
};

TEST(Assembly, IsTheLibrarysAtFreeUnknowns) {
  const TiedBlock block;
  Vector unused;
  const auto expected = block.expected(unused);
  const SymmetricMatrix<3> assembled = block.assembled(unused);
  Vector product(block.owned(), MPI_COMM_WORLD);
  Vector difference(product);
  for (const double seed : {1., 2., 3.}) {
    const Vector vector = block.some_vector(seed);
    assembled.vmult(product, vector);
    // deal.II's own product has another name in clang++ than in the g++ that has compiled it
    const Epetra_CrsMatrix& by_library = expected->trilinos_matrix();
    const Epetra_Vector from(View, by_library.DomainMap(), const_cast<double*>(vector.begin()));
    Epetra_Vector to(View, by_library.RangeMap(), difference.begin());
    by_library.Multiply(false, from, to);
    difference -= product;
    EXPECT_LT(difference.linfty_norm(), 1e-13 * product.linfty_norm());
  }
}

TEST(Assembly, LoadsFreeUnknownsAsTheLibraryDoes) {
  const TiedBlock block;
  Vector assembled;
  Vector expected;
  static_cast<void>(block.assembled(assembled));
  static_cast<void>(block.expected(expected));
  Vector load(block.owned(), MPI_COMM_WORLD);
  Vector difference(load);
  load.copy_locally_owned_data_from(assembled);
  difference.copy_locally_owned_data_from(expected);
  difference -= load;
  EXPECT_GT(load.linfty_norm(), 0.);
  EXPECT_LT(difference.linfty_norm(), 1e-13 * load.linfty_norm());
}

TEST(Assembly, LeavesConstrainedUnknownsAloneWithAStiffness) {
  const TiedBlock block;
  Vector unused;
  const SymmetricMatrix<3> matrix = block.assembled(unused);
  Vector unit(block.owned(), MPI_COMM_WORLD);
  for (const auto unknown : block.owned())
    unit(unknown) = block.constraints().is_constrained(unknown) ? 1. : 0.;
  unit.compress(dealii::VectorOperation::insert);
  Vector product(unit);
  matrix.vmult(product, unit);
  for (const auto unknown : block.owned())
    if (block.constraints().is_constrained(unknown))
      EXPECT_GT(product(unknown), 0.1);
    else
      EXPECT_EQ(product(unknown), 0.);
  EXPECT_GT(unit.l1_norm(), 100.);
}

}  // namespace
}  // namespace geneva::fem::test
