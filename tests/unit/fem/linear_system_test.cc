#include "fem/linear/linear_system.h"

#include <deal.II/dofs/dof_tools.h>
#include <gtest/gtest.h>

#include "fem/discretisation/boundary.h"
#include "fem/linear/condensation.h"
#include "fem/linear/constraints.h"
#include "mesh/extrusion.h"
#include "tests/unit/fem/discretisation.h"

namespace geneva::fem::test {
namespace {

using geneva::test::equal_steps;
using Lines = std::vector<ConstraintLine>;

const Material steel{2., 0.3};

/// A ring sector that is held at its lower face and pulled at its upper one; unknowns of its outer
/// surface can be tied to others.
class TiedSector {
 public:
  TiedSector() {
    for (const std::string& body : mesh_.bodies) problem_.bodies.push_back({body, steel, {}});
    problem_.loads.push_back({"upper", 0., {0.1, 0.2, 0.3}});
    const Boundary<3> boundary = gather_boundary(*grid_.dof_handler, mesh_.circles, 1.);
    supports_ = support_lines<3>(boundary, {{"lower", {0., 0., 0.}}}, mesh_.surfaces);
    dealii::DoFTools::extract_locally_relevant_dofs(*grid_.dof_handler, ghosts_);
    for (const BoundaryNode<3>& node : boundary.nodes)
      ghosts_.add_indices(node.dofs.begin(), node.dofs.end());
    for (const BoundaryFace<3>& face : boundary.faces)
      if (mesh_.surfaces[face.surface] == "outer")
        for (const unsigned int node : face.nodes)
          if (boundary.nodes[node].position[2] > 0.) outer_.push_back(boundary.nodes[node].dofs);
    cells_ = cell_systems(*grid_.dof_handler, problem_, mesh_.surfaces);
  }

  /// Ties the x of an outer node to its own y and to another node, with an offset.
  [[nodiscard]] ConstraintLine tie(const std::size_t node, const std::size_t other,
                                   const double offset) const {
    return {outer_.at(node)[0],
            {{outer_.at(node)[1], 0.4}, {outer_.at(other)[0], 0.7}, {outer_.at(other)[2], -0.2}},
            offset};
  }

  [[nodiscard]] dealii::AffineConstraints<double> constraints(const Lines& ties) const {
    Lines lines = supports_;
    lines.insert(lines.end(), ties.begin(), ties.end());
    return make_constraints(hanging_nodes(*grid_.dof_handler, ghosts_), lines);
  }

  /// Assembled with the ties.
  [[nodiscard]] LinearSystem<3> system(const Lines& ties) const {
    return {*grid_.dof_handler, ghosts_, constraints(ties), cells_, {}};
  }

  /// Assembled without ties, which are put in later.
  void constrain(LinearSystem<3>& system, const Lines& ties) const {
    system.constrain({constraints(ties)});
  }

  [[nodiscard]] Vector solved(LinearSystem<3>& system) const {
    system.set_up(*grid_.dof_handler, Method::multigrid);
    Vector displacement(grid_.dof_handler->locally_owned_dofs(), MPI_COMM_WORLD);
    system.solve(displacement, 1e-13, 0.);
    return displacement;
  }

  /// Of a system with multigrid, from zero.
  [[nodiscard]] unsigned int iterations(const LinearSystem<3>& system) const {
    Vector displacement(grid_.dof_handler->locally_owned_dofs(), MPI_COMM_WORLD);
    return system.solve(displacement, 1e-10, 0.);
  }

  void set_up_multigrid(LinearSystem<3>& system) const {
    system.set_up(*grid_.dof_handler, Method::multigrid);
  }

  void set_up_library(LinearSystem<3>& system) const {
    system.set_up(*grid_.dof_handler, Method::library_multigrid);
  }

  void factorise(LinearSystem<3>& system) const {
    system.set_up(*grid_.dof_handler, Method::factors);
  }

  [[nodiscard]] const CellSystems& cells() const { return cells_; }

 private:
  static mesh::MeshData<3> sector() {
    mesh::MeshData<2> plane = geneva::test::empty_mesh();
    geneva::test::add_ring(
        plane, "sector",
        {{0., 0.}, {0.5, 0.8, 1.}, equal_steps(0.3, 1.9, 4), "inner", "outer", "", ""});
    return extruded(plane, {{{-0.2, 0.1, 0.2, 0.7}, "lower", "upper"}});
  }

  mesh::MeshData<3> mesh_ = sector();
  Discretisation<3> grid_{mesh_, 1};
  Problem<3> problem_;
  Lines supports_;
  dealii::IndexSet ghosts_;
  std::vector<std::array<dealii::types::global_dof_index, 3>> outer_;
  CellSystems cells_;
};

void expect_same(const Vector& one, const Vector& other) {
  Vector difference(one);
  difference -= other;
  EXPECT_LT(difference.linfty_norm(), 1e-11 * one.linfty_norm());
}

TEST(LinearSystem, EliminatedUnknownsGiveWhatAssemblingTheirConstraintsGives) {
  const TiedSector sector;
  const Lines first{sector.tie(0, 9, 0.01), sector.tie(4, 9, 0.02), sector.tie(12, 17, -0.03)};
  const Lines second{sector.tie(4, 9, 0.02), sector.tie(12, 17, 0.05), sector.tie(21, 30, -0.01)};
  LinearSystem<3> assembled = sector.system(second);
  LinearSystem<3> eliminated = sector.system({});
  sector.constrain(eliminated, first);
  const Vector before = sector.solved(eliminated);
  sector.constrain(eliminated, second);
  const Vector expected = sector.solved(assembled);
  expect_same(expected, sector.solved(eliminated));
  Vector difference(before);
  difference -= expected;
  EXPECT_GT(difference.linfty_norm(), 1e-3 * expected.linfty_norm());
}

TEST(LinearSystem, ForgetsWhatWasEliminatedBefore) {
  const TiedSector sector;
  LinearSystem<3> untouched = sector.system({});
  LinearSystem<3> freed = sector.system({});
  sector.constrain(freed, {sector.tie(0, 9, 0.01), sector.tie(4, 9, 0.02)});
  sector.constrain(freed, {});
  expect_same(sector.solved(untouched), sector.solved(freed));
}

/// Whose factors go over to other constraints, also of unknowns constrained by those of other
/// ranks.
TEST(LinearSystem, FactorisedOneIsSolvedAtOnceAndIsTheSame) {
  const TiedSector sector;
  LinearSystem<3> system = sector.system({});
  sector.constrain(system, {sector.tie(0, 9, 0.01), sector.tie(4, 9, 0.02)});
  const Vector expected = sector.solved(system);
  LinearSystem<3> factorised = sector.system({});
  sector.factorise(factorised);
  sector.constrain(factorised, {sector.tie(0, 9, 0.01), sector.tie(4, 9, 0.02)});
  Vector displacement(expected);
  displacement = 0.;
  EXPECT_LE(factorised.solve(displacement, 1e-12, 0.), 2U);
  expect_same(expected, displacement);
}

/// Also after its constraints have changed.
TEST(LinearSystem, LibrarysMultigridGivesTheSame) {
  const TiedSector sector;
  const Lines ties{sector.tie(0, 9, 0.01), sector.tie(4, 9, 0.02), sector.tie(12, 17, -0.03)};
  LinearSystem<3> system = sector.system({});
  sector.constrain(system, ties);
  const Vector expected = sector.solved(system);
  LinearSystem<3> other = sector.system({});
  sector.set_up_library(other);
  Vector displacement(expected);
  displacement = 0.;
  EXPECT_LT(other.solve(displacement, 1e-13, 0.), 100U);
  sector.constrain(other, ties);
  EXPECT_LT(other.solve(displacement, 1e-13, 0.), 100U);
  expect_same(expected, displacement);
}

/// Measured on one, two and three ranks: 21 to 25 with a multigrid of its own, one or two more
/// after the changes.
TEST(LinearSystem, ChangedConstraintsCostFewIterations) {
  const TiedSector sector;
  Lines ties;
  for (std::size_t i = 0; i < 12; ++i) ties.push_back(sector.tie(3 * i, 3 * i + 1, 0.01));
  for (const auto& [first, second] : {std::pair{Lines{}, ties}, std::pair{ties, Lines{}}}) {
    LinearSystem<3> assembled = sector.system(second);
    sector.set_up_multigrid(assembled);
    LinearSystem<3> changed = sector.system({});
    sector.constrain(changed, first);
    sector.set_up_multigrid(changed);
    sector.constrain(changed, second);
    EXPECT_LE(sector.iterations(changed), sector.iterations(assembled) + 3);
  }
}

TEST(LinearSystem, SmoothingLowersTheResidualWithoutMultigrid) {
  const TiedSector sector;
  LinearSystem<3> system = sector.system({sector.tie(0, 9, 0.01)});
  Vector smoothed = sector.solved(system);
  const Vector exact = smoothed;
  smoothed *= 1.1;
  EXPECT_EQ(system.smooth(smoothed), 15U);
  smoothed -= exact;
  EXPECT_LT(smoothed.l2_norm(), 0.1 * exact.l2_norm());
}

TEST(Condensation, AUniformTranslationNeedsNoForce) {
  const TiedSector sector;
  const CellSystem cell = sector.cells()[0];
  dealii::AffineConstraints<double> constraints;
  constraints.add_line(cell.dofs[0]);
  constraints.add_entry(cell.dofs[0], cell.dofs[3], 0.25);
  constraints.add_entry(cell.dofs[0], cell.dofs[6], 0.75);
  constraints.close();
  const CellSystem free = condensed(cell, constraints);
  EXPECT_EQ(free.dofs.size(), cell.dofs.size() - 1);
  dealii::Vector<double> translation(free.load.size());
  dealii::Vector<double> force(free.load.size());
  for (unsigned int i = 0; i < translation.size(); ++i) {
    const auto place = std::find(cell.dofs.begin(), cell.dofs.end(), free.dofs[i]);
    translation[i] = (place - cell.dofs.begin()) % 3 == 0 ? 1. : 0.;
  }
  free.stiffness.vmult(force, translation);
  EXPECT_LT(force.linfty_norm(), 1e-13 * free.stiffness.linfty_norm());
}

}  // namespace
}  // namespace geneva::fem::test
