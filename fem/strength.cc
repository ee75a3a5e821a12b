#include "fem/strength.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/discretisation/gather.h"
#include "fem/discretisation/round_cell.h"
#include "fem/outside_of_contact.h"
#include "fem/stress_error.h"
#include "fem/stress_variation.h"

namespace geneva::fem {

namespace {

using dealii::Point;
using dealii::Tensor;

/// A node of this rank's cells.
template <int dim>
struct Candidate {
  StressCell<dim> cell;
  unsigned int vertex;
  double value;  ///< [Pa]
};

/// The nodes of this rank's cells of a body that have a positive value, the greatest first.
template <int dim>
std::vector<Candidate<dim>> candidates(const NodalStress<dim>& stress, const unsigned int body,
                                       const Measure measure) {
  std::vector<Candidate<dim>> result;
  std::vector<bool> is_known(stress.dof_handler->get_triangulation().n_vertices(), false);
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->material_id() != body) continue;
    for (const unsigned int vertex : cell->vertex_indices()) {
      if (is_known[cell->vertex_index(vertex)]) continue;
      is_known[cell->vertex_index(vertex)] = true;
      const double value = measured<dim>(stress.values, cell, vertex, measure);
      if (value > 0.) result.push_back({cell, vertex, value});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.value > b.value; });
  return result;
}

/// A node beside another one along the boundary.
struct Beside {
  Tensor<1, 2> offset;  ///< in the units of the triangulation
  double value;
};

/// The two neighbours of a node of the boundary; fewer of a node inside.
std::vector<Beside> beside(const NodalStress<2>& stress, const Candidate<2>& node,
                           const Measure measure) {
  const Point<2>& place = node.cell->vertex(node.vertex);
  std::vector<Beside> result;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (cell->is_artificial() || !cell->at_boundary() ||
        cell->material_id() != node.cell->material_id())
      continue;
    for (const unsigned int face : cell->face_indices())
      for (const unsigned int end : {0U, 1U}) {
        const auto vertex = [&](const unsigned int i) {
          return dealii::GeometryInfo<2>::face_to_cell_vertices(face, i);
        };
        if (!cell->face(face)->at_boundary() || cell->vertex(vertex(end)) != place) continue;
        result.push_back({cell->vertex(vertex(1 - end)) - place,
                          measured<2>(stress.values, cell, vertex(1 - end), measure)});
      }
  }
  return result;
}

/// Whether the boundary turns a corner between two neighbours, along which stresses are not smooth,
/// and no round of a coarse mesh.
bool turns_corner(const Beside& before, const Beside& after) {
  constexpr double cosine_of_most = 0.5;  // 60 degrees
  return -before.offset * after.offset <
         cosine_of_most * before.offset.norm() * after.offset.norm();
}

/// Moves a maximum from its node to the top of the parabola through its neighbours' values.
void move_to_top(StressMaximum<2>& maximum, const std::vector<Beside>& neighbours,
                 const double length) {
  if (neighbours.size() != 2 || turns_corner(neighbours[0], neighbours[1])) return;
  const double before = neighbours[0].offset.norm();
  const double after = neighbours[1].offset.norm();
  const double fall_before = maximum.value - neighbours[0].value;
  const double fall_after = maximum.value - neighbours[1].value;
  // value(s) = maximum + slope s - curvature s^2 through (-before) and (after)
  const double curvature = (fall_before / before + fall_after / after) / (before + after);
  const double slope = fall_before / before - curvature * before;
  if (!(curvature > 0.)) return;
  const double top = std::clamp(slope / (2. * curvature), -before, after);
  maximum.value += slope * top - curvature * top * top;
  const Tensor<1, 2> way =
      top > 0. ? (top / after) * neighbours[1].offset : (-top / before) * neighbours[0].offset;
  for (unsigned int i = 0; i < 2; ++i) maximum.place[i] += way[i] * length;
}

/// Tells the surface on which a node lies, a round one if there are several: of any cell, since the
/// node's own may touch the boundary with that node alone.
template <int dim>
void set_surface(StressMaximum<dim>& maximum, const NodalStress<dim>& stress,
                 const Candidate<dim>& node) {
  const unsigned int vertex = node.cell->vertex_index(node.vertex);
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (cell->is_artificial() || !cell->at_boundary() ||
        cell->material_id() != node.cell->material_id())
      continue;
    for (const auto& face : cell->face_iterators())
      for (const unsigned int i : face->vertex_indices()) {
        if (!face->at_boundary() || maximum.is_round || face->vertex_index(i) != vertex) continue;
        maximum.surface = static_cast<int>(face->boundary_id());
        maximum.is_round = is_round(face);
      }
  }
}

/// Whether a cell that may hide a maximum is at a node.
template <int dim>
bool touches_hiding_cell(const Solution<dim>& solution, const NodalStress<dim>& stress,
                         const Candidate<dim>& node) {
  const unsigned int vertex = node.cell->vertex_index(node.vertex);
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (cell->is_artificial()) continue;
    const auto vertices = cell->vertex_indices();
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&](const auto i) { return cell->vertex_index(i) == vertex; }) &&
        may_hide_maximum<dim>(solution, cell))
      return true;
  }
  return false;
}

template <int dim>
StressMaximum<dim> of_node(const Solution<dim>& solution, const NodalStress<dim>& stress,
                           const Candidate<dim>& node, const Measure measure) {
  StressMaximum<dim> maximum;
  maximum.value = node.value;
  for (unsigned int i = 0; i < dim; ++i)
    maximum.place[i] = node.cell->vertex(node.vertex)[i] * solution.scales.length;
  set_surface(maximum, stress, node);
  maximum.error =
      measured<dim>(stress.doubt, node.cell, node.vertex, Measure::von_mises) / node.value;
  maximum.may_be_hidden = has_contact(solution.problem) && maximum.is_round &&
                          touches_hiding_cell(solution, stress, node);
  if constexpr (dim == 2)
    move_to_top(maximum, beside(stress, node, measure), solution.scales.length);
  return maximum;
}

/// A maximum, and the greatest value of a node, beside which it is: that decides between ranks,
/// lest the result depend on their number.
template <int dim>
struct FoundMaximum {
  StressMaximum<dim> maximum;
  double at_node = 0.;  ///< [Pa]
};

/// The maximum of all ranks.
template <int dim>
StressMaximum<dim> of_all_ranks(const MPI_Comm communicator, FoundMaximum<dim> greatest) {
  const auto order = [](const FoundMaximum<dim>& found) {
    return std::make_pair(-found.at_node, found.maximum.place);
  };
  for (const FoundMaximum<dim>& of_rank : gathered_one(communicator, greatest))
    if (order(of_rank) < order(greatest)) greatest = of_rank;
  return greatest.maximum;
}

/// This rank's greatest value outside, by the share of the contacts' own field that is allowed; 0
/// if there is none. Nodes without tension are none of the tensile stress.
template <int dim>
FoundMaximum<dim> greatest(const Solution<dim>& solution, const NodalStress<dim>& stress,
                           const std::vector<Candidate<dim>>& nodes,
                           const OutsideOfContact<dim>& is_outside, const Measure measure,
                           const double share) {
  constexpr double least_part = 1e-3;
  for (const Candidate<dim>& node : nodes) {
    const double von_mises =
        measured<dim>(stress.values, node.cell, node.vertex, Measure::von_mises);
    const Point<dim> place(node.cell->vertex(node.vertex) * solution.scales.length);
    if (node.value > least_part * von_mises &&
        is_outside(place, node.cell->material_id(), von_mises, share))
      return {of_node(solution, stress, node, measure), node.value};
  }
  return {};
}

/// The maximum over the ranks of what stands outside of the contacts' own field.
template <int dim>
StressMaximum<dim> maximum_of(const Solution<dim>& solution, const NodalStress<dim>& stress,
                              const OutsideOfContact<dim>& is_outside, const unsigned int body,
                              const Measure measure) {
  const auto nodes = candidates(stress, body, measure);
  const auto with_share = [&](const double share) {
    return of_all_ranks(solution.dof_handler->get_communicator(),
                        greatest(solution, stress, nodes, is_outside, measure, share));
  };
  StressMaximum<dim> maximum = with_share(OwnFieldShare::usual);
  if (maximum.value == 0.) return maximum;
  for (const double share : {OwnFieldShare::least, OwnFieldShare::most})
    maximum.choice = std::max(maximum.choice,
                              std::min(1., std::abs(with_share(share).value / maximum.value - 1.)));
  return maximum;
}

/// The fatigue strength of materials is a third of their yield strength or more (bearing steel):
/// with a tenth of the von Mises stress the tensile stress is three times as safe.
template <int dim>
bool is_minor(const BodyStrength<dim>& found) {
  constexpr double share = 0.1;
  return found.tensile.value < share * found.von_mises.value;
}

/// Adds what a mesh leaves of maxima over whose cells the stress varies by a share of them,
/// wherever they are. A linear field that stands for one that decays leaves an eighth of the
/// square; measured at slot bottoms: up to a sixth.
template <int dim>
void add_left_by_cells(BodyStrength<dim>& found, const double varying) {
  const double share = varying / found.von_mises.value;
  for (StressMaximum<dim>* const maximum : {&found.von_mises, &found.tensile})
    if (maximum->value > 0.) maximum->error += share * share / 6.;
}

}  // namespace

template <int dim>
std::vector<BodyStrength<dim>> strength(const Solution<dim>& solution,
                                        const NodalStress<dim>& stress,
                                        const std::vector<SingularPlace<dim>>& singular) {
  const OutsideOfContact<dim> is_outside(solution, singular);
  std::vector<BodyStrength<dim>> result;
  for (unsigned int body = 0; body < solution.problem.bodies.size(); ++body) {
    if (solution.problem.bodies[body].is_cut_out) {
      result.emplace_back();
      continue;
    }
    BodyStrength<dim> found{maximum_of(solution, stress, is_outside, body, Measure::von_mises),
                            maximum_of(solution, stress, is_outside, body, Measure::tensile)};
    if (dim == 2 && has_contact(solution.problem))
      add_left_by_cells(found, maximum_variation(stress, is_outside, body));
    else
      for (StressMaximum<dim>* const maximum : {&found.von_mises, &found.tensile})
        maximum->open = open_by_cells(solution, stress, is_outside, body, *maximum);
    found.tensile.is_minor = dim == 3 && has_contact(solution.problem) && is_minor(found);
    result.push_back(found);
  }
  return result;
}

#define INSTANTIATE(dim)                                                                          \
  template std::vector<BodyStrength<dim>> strength(const Solution<dim>&, const NodalStress<dim>&, \
                                                   const std::vector<SingularPlace<dim>>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace geneva::fem
