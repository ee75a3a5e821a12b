#include "fem/stress_recovery.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "fem/boundary_stress.h"
#include "fem/discretisation/element.h"
#include "fem/elasticity/cell_element.h"
#include "fem/stress_patch.h"

namespace geneva::fem {

namespace {

using dealii::Point;
using dealii::Tensor;

template <int dim>
StressVector<dim> as_vector(const Stress<dim>& stress) {
  StressVector<dim> result;
  if constexpr (dim == 2)
    result << stress.in_plane[0][0], stress.in_plane[1][1], stress.out_of_plane,
        stress.in_plane[0][1];
  else
    result << stress[0][0], stress[1][1], stress[2][2], stress[0][1], stress[0][2], stress[1][2];
  return result;
}

/// See doubt_of_linear(). At Kirsch's hole, extrapolated from inside, with 64 cells around it, the
/// error was 1.5 times the relative difference.
constexpr double share_inside = 1.5;
template <int dim>
class StressRecovery {
 public:
  StressRecovery(const dealii::DoFHandler<dim>& dof_handler, const Vector& displacement,
                 const Problem<dim>& problem, const BoundaryTractions<dim>& tractions)
      : displaced_(dof_handler),
        displacement_(displacement),
        problem_(problem),
        at_boundary_(displacement, problem, tractions) {}

  NodalStress<dim> run() {
    number();
    look_at_cells();
    fit_inner_nodes();
    extrapolate_to_boundary();
    return finish();
  }

 private:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  using StressDofs = std::array<dealii::types::global_dof_index, n_stress_components<dim>>;
  /// A corner of a known cell.
  struct Corner {
    std::size_t cell;  ///< index into cells_
    unsigned int vertex;
  };

  void number();
  void look_at_cells();
  void fit_inner_nodes();
  void extrapolate_to_boundary();
  NodalStress<dim> finish();

  /// Calls task(vertex, its corner in one of the cells) for every node that this rank owns.
  template <typename Task>
  void visit_own_nodes(const Task& task) const;
  [[nodiscard]] StressDofs dofs_of(const Corner& corner) const;
  [[nodiscard]] bool is_on_boundary(const Corner& corner) const {
    return boundary_(dofs_of(corner)[0]) > 0.;
  }
  [[nodiscard]] bool is_inner(const Corner& corner) const {
    return !is_on_boundary(corner) && !hanging_.is_constrained(dofs_of(corner)[0]);
  }
  [[nodiscard]] bool has_boundary_neighbour(const std::vector<Corner>& corners) const;
  [[nodiscard]] std::vector<CellCorner<dim>> cell_corners(const std::vector<Corner>& corners) const;
  [[nodiscard]] std::vector<Sample<dim>> samples_around(const std::vector<Corner>& corners) const;
  [[nodiscard]] std::vector<Corner> inner_neighbours(const std::vector<Corner>& corners) const;
  void set(const StressDofs& dofs, const StressVector<dim>& stress, const StressVector<dim>& doubt);
  [[nodiscard]] StressVector<dim> mean_around(const std::vector<Corner>& corners) const;
  [[nodiscard]] StressVector<dim> images_mean(const std::vector<Corner>& corners,
                                              StressVector<dim> stress) const;

  const dealii::DoFHandler<dim>& displaced_;
  const Vector& displacement_;
  const Problem<dim>& problem_;
  BoundaryStress<dim> at_boundary_;
  NodalStress<dim> result_;
  dealii::IndexSet relevant_;
  dealii::AffineConstraints<double> hanging_;
  std::vector<Cell> cells_;                   ///< of the displacement, own and ghosts
  std::vector<Sample<dim>> samples_;          ///< of those
  std::vector<std::vector<Corner>> corners_;  ///< by vertex
  Vector boundary_;  ///< > 0 at the first component of nodes of the boundary
  std::map<unsigned int, LinearStress<dim>> fits_;  ///< of own inner nodes beside the boundary
};

template <int dim>
void StressRecovery<dim>::number() {
  result_.element = linear_element<dim>(n_stress_components<dim>);
  result_.dof_handler = std::make_unique<dealii::DoFHandler<dim>>(displaced_.get_triangulation());
  result_.dof_handler->distribute_dofs(*result_.element);
  dealii::DoFTools::extract_locally_relevant_dofs(*result_.dof_handler, relevant_);
  hanging_.reinit(relevant_);
  dealii::DoFTools::make_hanging_node_constraints(*result_.dof_handler, hanging_);
  hanging_.close();
}

template <int dim>
typename StressRecovery<dim>::StressDofs StressRecovery<dim>::dofs_of(const Corner& corner) const {
  const Cell& cell = cells_[corner.cell];
  const Cell stressed(&result_.dof_handler->get_triangulation(), cell->level(), cell->index(),
                      result_.dof_handler.get());
  StressDofs dofs;
  for (unsigned int i = 0; i < dofs.size(); ++i)
    dofs[i] = stressed->vertex_dof_index(corner.vertex, i);
  return dofs;
}

template <int dim>
void StressRecovery<dim>::look_at_cells() {
  CellStresses<dim> evaluate(problem_, dealii::QMidpoint<dim>());
  corners_.resize(displaced_.get_triangulation().n_vertices());
  boundary_.reinit(result_.dof_handler->locally_owned_dofs(), relevant_,
                   displaced_.get_communicator());
  for (const Cell& cell : displaced_.active_cell_iterators()) {
    if (cell->is_artificial()) continue;
    cells_.push_back(cell);
    const PointStress<dim> middle = evaluate(cell, displacement_).front();
    samples_.push_back({middle.place, as_vector<dim>(middle.stress)});
    for (const unsigned int vertex : cell->vertex_indices())
      corners_[cell->vertex_index(vertex)].push_back({cells_.size() - 1, vertex});
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && !at_boundary_.mirror_axis(cell, face))
        for (const unsigned int i : cell->face(face)->vertex_indices())
          boundary_(dofs_of({cells_.size() - 1,
                             dealii::GeometryInfo<dim>::face_to_cell_vertices(face, i)})[0]) += 1.;
  }
  boundary_.compress(dealii::VectorOperation::add);
  boundary_.update_ghost_values();
}

template <int dim>
template <typename Task>
void StressRecovery<dim>::visit_own_nodes(const Task& task) const {
  const dealii::IndexSet& own = result_.dof_handler->locally_owned_dofs();
  for (unsigned int vertex = 0; vertex < corners_.size(); ++vertex) {
    if (corners_[vertex].empty()) continue;
    const dealii::types::global_dof_index dof = dofs_of(corners_[vertex].front())[0];
    if (own.is_element(dof) && !hanging_.is_constrained(dof)) task(vertex, corners_[vertex]);
  }
}

template <int dim>
std::vector<CellCorner<dim>> StressRecovery<dim>::cell_corners(
    const std::vector<Corner>& corners) const {
  std::vector<CellCorner<dim>> result;
  for (const Corner& corner : corners) result.push_back({cells_[corner.cell], corner.vertex});
  return result;
}

/// With their images.
template <int dim>
std::vector<Sample<dim>> StressRecovery<dim>::samples_around(
    const std::vector<Corner>& corners) const {
  std::vector<Sample<dim>> samples;
  for (const Corner& corner : corners) samples.push_back(samples_[corner.cell]);
  for (const Mirror& mirror : at_boundary_.mirrors_at(cell_corners(corners))) {
    const std::size_t n = samples.size();
    for (std::size_t i = 0; i < n; ++i) samples.push_back(mirrored(samples[i], mirror));
  }
  return samples;
}

template <int dim>
bool StressRecovery<dim>::has_boundary_neighbour(const std::vector<Corner>& corners) const {
  return std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) {
    for (unsigned int vertex = 0; vertex < (1U << dim); ++vertex)
      if (is_on_boundary({corner.cell, vertex})) return true;
    return false;
  });
}

template <int dim>
void StressRecovery<dim>::fit_inner_nodes() {
  result_.values.reinit(result_.dof_handler->locally_owned_dofs(), relevant_,
                        displaced_.get_communicator());
  result_.doubt.reinit(result_.values);
  visit_own_nodes([&](const unsigned int vertex, const std::vector<Corner>& corners) {
    if (is_on_boundary(corners.front())) return;
    const Corner& first = corners.front();
    const LinearStress<dim> fit =
        fitted<dim>(cells_[first.cell]->vertex(first.vertex), samples_around(corners));
    const StressDofs dofs = dofs_of(first);
    const StressVector<dim> stress = fit.row(0).transpose();
    set(dofs, stress, doubt_of_linear<dim>(stress, mean_around(corners), share_inside));
    if (has_boundary_neighbour(corners)) fits_[vertex] = fit;
  });
}

/// Those at the other end of an edge, or, if there are none, of the cells around.
template <int dim>
std::vector<typename StressRecovery<dim>::Corner> StressRecovery<dim>::inner_neighbours(
    const std::vector<Corner>& corners) const {
  for (const bool is_edge : {true, false}) {
    std::map<unsigned int, Corner> found;
    for (const Corner& corner : corners)
      for (unsigned int vertex = 0; vertex < (1U << dim); ++vertex) {
        const unsigned int across = corner.vertex ^ vertex;
        const bool is_one_axis = (across & (across - 1)) == 0;
        if (is_one_axis != is_edge || !is_inner({corner.cell, vertex})) continue;
        found.emplace(cells_[corner.cell]->vertex_index(vertex), Corner{corner.cell, vertex});
      }
    if (found.empty()) continue;
    std::vector<Corner> neighbours;
    for (const auto& [vertex, corner] : found) neighbours.push_back(corner);
    return neighbours;
  }
  return {};
}

/// The derivatives of the inner nodes' stresses travel one after the other.
template <int dim>
void StressRecovery<dim>::extrapolate_to_boundary() {
  std::map<unsigned int, StressVector<dim>> extrapolated;
  Vector part(result_.dof_handler->locally_owned_dofs(), relevant_, displaced_.get_communicator());
  for (unsigned int k = 0; k <= dim; ++k) {
    part = 0.;
    for (const auto& [vertex, fit] : fits_) {
      const StressDofs dofs = dofs_of(corners_[vertex].front());
      for (unsigned int i = 0; i < dofs.size(); ++i) part(dofs[i]) = fit(k, i);
    }
    part.update_ghost_values();
    visit_own_nodes([&](const unsigned int vertex, const std::vector<Corner>& corners) {
      if (!is_on_boundary(corners.front())) return;
      const auto neighbours = inner_neighbours(corners);
      if (neighbours.empty()) return;
      const Point<dim> place = cells_[corners.front().cell]->vertex(corners.front().vertex);
      StressVector<dim>& sum =
          extrapolated.emplace(vertex, StressVector<dim>::Zero()).first->second;
      for (const Corner& neighbour : neighbours) {
        const Point<dim> from = cells_[neighbour.cell]->vertex(neighbour.vertex);
        const double factor = k == 0 ? 1. : place[k - 1] - from[k - 1];
        const StressDofs dofs = dofs_of(neighbour);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          sum[i] += factor * part(dofs[i]) / static_cast<double>(neighbours.size());
      }
    });
    part.zero_out_ghost_values();
  }
  visit_own_nodes([&](const unsigned int vertex, const std::vector<Corner>& corners) {
    if (!is_on_boundary(corners.front())) return;
    const auto found = extrapolated.find(vertex);
    const StressVector<dim> mean = mean_around(corners);
    const StressVector<dim> inside =
        images_mean(corners, found == extrapolated.end() ? mean : found->second);
    const auto [stress, doubt] = at_boundary_.at(
        cell_corners(corners), {inside, doubt_of_linear<dim>(inside, mean, share_inside)});
    set(dofs_of(corners.front()), stress, doubt);
  });
}

template <int dim>
void StressRecovery<dim>::set(const StressDofs& dofs, const StressVector<dim>& stress,
                              const StressVector<dim>& doubt) {
  for (unsigned int i = 0; i < dofs.size(); ++i) {
    result_.values(dofs[i]) = stress[i];
    result_.doubt(dofs[i]) = doubt[i];
  }
}

template <int dim>
StressVector<dim> StressRecovery<dim>::mean_around(const std::vector<Corner>& corners) const {
  StressVector<dim> sum = StressVector<dim>::Zero();
  for (const Corner& corner : corners) sum += samples_[corner.cell].stress;
  return sum / static_cast<double>(corners.size());
}

/// Together with the stresses of its images: on a plane of symmetry shears with its axis are none.
template <int dim>
StressVector<dim> StressRecovery<dim>::images_mean(const std::vector<Corner>& corners,
                                                   StressVector<dim> stress) const {
  for (const Mirror& mirror : at_boundary_.mirrors_at(cell_corners(corners)))
    stress = 0.5 * (stress + mirrored(Sample<dim>{{}, stress}, mirror).stress);
  return stress;
}

/// Hanging nodes follow the others.
template <int dim>
NodalStress<dim> StressRecovery<dim>::finish() {
  for (Vector* const values : {&result_.values, &result_.doubt}) {
    Vector own = without_ghosts(*values);
    hanging_.distribute(own);
    replace(*values, with_ghosts(own, relevant_));
  }
  return std::move(result_);
}

}  // namespace

template <int dim>
NodalStress<dim> recovered_stress(const dealii::DoFHandler<dim>& dof_handler,
                                  const Vector& displacement, const Problem<dim>& problem,
                                  const BoundaryTractions<dim>& tractions) {
  return StressRecovery<dim>(dof_handler, displacement, problem, tractions).run();
}

template NodalStress<2> recovered_stress(const dealii::DoFHandler<2>&, const Vector&,
                                         const Problem<2>&, const BoundaryTractions<2>&);
template NodalStress<3> recovered_stress(const dealii::DoFHandler<3>&, const Vector&,
                                         const Problem<3>&, const BoundaryTractions<3>&);

}  // namespace geneva::fem
