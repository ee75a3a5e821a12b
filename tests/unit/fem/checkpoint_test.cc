#include "fem/checkpoint.h"

#include <deal.II/dofs/dof_tools.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "discretisation.h"

namespace geneva::fem {
namespace {

using nlohmann::json;
using test::Discretisation;

/// A square of 4 x 4 cells, whose corner at the origin is refined three times if wanted.
Discretisation<2> square(const bool is_refined) {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "square", geneva::test::equal_steps(0., 1., 4),
                              geneva::test::equal_steps(0., 1., 4), {"", "", "", ""});
  Discretisation<2> grid(mesh);
  for (int i = 0; is_refined && i < 3; ++i) {
    for (const auto& cell : grid.triangulation->active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().norm() < 0.4) cell->set_refine_flag();
    grid.triangulation->execute_coarsening_and_refinement();
  }
  grid.dof_handler->distribute_dofs(grid.dof_handler->get_fe());
  return grid;
}

double value_at(const dealii::Point<2>& place, const unsigned int component) {
  return 1. + 2. * place[0] - (3. + component) * place[1];
}

/// Sets or compares the values at the corners of this rank's cells.
template <typename Visit>
void visit_corners(const Discretisation<2>& grid, const Visit& visit) {
  for (const auto& cell : grid.dof_handler->active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int i : cell->vertex_indices())
        for (unsigned int component = 0; component < 2; ++component)
          visit(cell->vertex_dof_index(i, component), value_at(cell->vertex(i), component));
}

Vector linear_field(const Discretisation<2>& grid) {
  const dealii::IndexSet owned = grid.dof_handler->locally_owned_dofs();
  Vector own(owned, MPI_COMM_WORLD);
  visit_corners(grid, [&](const auto dof, const double value) {
    if (owned.is_element(dof)) own(dof) = value;
  });
  own.compress(dealii::VectorOperation::insert);
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(*grid.dof_handler, relevant);
  Vector field(owned, relevant, MPI_COMM_WORLD);
  field = own;
  return field;
}

SavedField<2> saved() {
  const Discretisation<2> grid = square(true);
  return saved_field(*grid.dof_handler, linear_field(grid));
}

TEST(SavedField, HasEveryCellAndNodeOnceAndIsTheSameOnAllRanks) {
  const Discretisation<2> grid = square(true);
  const SavedField<2> field = saved_field(*grid.dof_handler, linear_field(grid));
  EXPECT_NO_THROW(check(field));
  EXPECT_EQ(field.cells.size(), grid.triangulation->n_global_active_cells());
  EXPECT_EQ(2 * field.n_nodes(), grid.dof_handler->n_dofs());
  EXPECT_EQ(dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, field.displacement),
            field.displacement);
}

TEST(SavedField, GivesTheMeshAndTheValuesBack) {
  const SavedField<2> field = saved();
  Discretisation<2> other = square(false);
  refine_as(*other.triangulation, field);
  EXPECT_EQ(other.triangulation->n_global_active_cells(), field.cells.size());
  other.dof_handler->distribute_dofs(other.dof_handler->get_fe());
  const Vector values = field_on(*other.dof_handler, field);
  visit_corners(other, [&](const auto dof, const double value) {
    if (other.dof_handler->locally_owned_dofs().is_element(dof)) {
      EXPECT_DOUBLE_EQ(values(dof), value);
    }
  });
}

TEST(SavedField, CellsThatTheCoarseMeshDoesNotHaveAreRefused) {
  SavedField<2> field = saved();
  field.cells.back()[0] = 99;  // coarse cell
  Discretisation<2> other = square(false);
  EXPECT_THROW(refine_as(*other.triangulation, field), base::InputError);
}

TEST(SavedField, WrongOrderIndicesAndValuesAreRefused) {
  const SavedField<2> good = saved();
  SavedField<2> field = good;
  std::swap(field.cells.front(), field.cells.back());
  EXPECT_THROW(check(field), base::InputError);
  field = good;
  field.nodes.front() = static_cast<unsigned int>(field.n_nodes());
  EXPECT_THROW(check(field), base::InputError);
  field = good;
  field.nodes.pop_back();
  EXPECT_THROW(check(field), base::InputError);
  field = good;
  field.displacement.front() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check(field), base::InputError);
  EXPECT_THROW(check(SavedField<2>()), base::InputError);
}

LevelRecord record(const unsigned int cells) {
  LevelRecord level{};
  level.cells = cells;
  level.dofs = 42;
  level.linear_iterations = {3, 1};
  level.peak_pressure = 1. / 3.;
  level.refined = Refined::surroundings;
  level.grading = 0.1;
  level.cycled = true;
  level.seconds = 1e-300;
  return level;
}

Checkpoint<2> checkpoint() {
  Checkpoint<2> result{saved(), {{{0.1, 0.2}}, {{0.3, 0.4}}}, {{{1. / 7., 0.}, {0., 1.}}}, {}, {}};
  const auto cells = static_cast<unsigned int>(result.field.cells.size());
  result.history = {record(cells / 2), record(cells)};
  result.refinement = {7, true, 0.25, 2, std::numeric_limits<double>::max(), 40};
  return result;
}

TEST(Checkpoint, ComesBackToTheLastDigitThroughItsText) {
  const Checkpoint<2> before = checkpoint();
  const json text = json::parse(json_of(before).dump());
  const Checkpoint<2> after = checkpoint_of(text, before.field);
  EXPECT_EQ(json_of(after), json_of(before));
  EXPECT_EQ(after.active[0][0], before.active[0][0]);
  EXPECT_EQ(after.history[1].peak_pressure, 1. / 3.);
  EXPECT_EQ(after.history[1].refined, Refined::surroundings);
  EXPECT_EQ(after.refinement.unevenness_levelled, std::numeric_limits<double>::max());
}

TEST(Checkpoint, WithoutAnyOneOfItsMembersItIsRefused) {
  const Checkpoint<2> good = checkpoint();
  const json whole = json_of(good);
  const json flat = whole.flatten();
  for (const auto& [path, value] : flat.items()) {
    const json::json_pointer place(path);
    if (whole.at(place.parent_pointer()).is_array()) continue;  // one of a list more or less
    json part = whole;
    part.at(place.parent_pointer()).erase(place.back());
    EXPECT_THROW(checkpoint_of(part, good.field), base::InputError) << path;
  }
}

TEST(Checkpoint, AnythingElseThanWhatIsWantedIsRefused) {
  const Checkpoint<2> good = checkpoint();
  const json whole = json_of(good);
  const json flat = whole.flatten();
  for (const auto& [path, value] : flat.items())
    for (const json& wrong : {json("text"), json(nullptr), json(json::array({json::array()}))}) {
      json other = whole;
      other.at(json::json_pointer(path)) = wrong;
      EXPECT_THROW(checkpoint_of(other, good.field), base::InputError) << path << " " << wrong;
    }
}

TEST(Checkpoint, AHistoryOfAnotherMeshIsRefused) {
  Checkpoint<2> other = checkpoint();
  other.history.back().cells += 3;
  EXPECT_THROW(checkpoint_of(json_of(other), other.field), base::InputError);
  other.history.clear();
  EXPECT_THROW(checkpoint_of(json_of(other), other.field), base::InputError);
}

}  // namespace
}  // namespace geneva::fem
