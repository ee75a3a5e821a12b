#include "fem/strength.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "fem/discretisation/gather.h"
#include "fem/discretisation/refined_mesh.h"
#include "fem/discretisation/round_cell.h"
#include "fem/elasticity/invariants.h"
#include "fem/stress_error.h"
#include "fem/stress_variation.h"

namespace geneva::fem {

namespace {

using dealii::Point;
using dealii::Tensor;

template <int dim>
using StressCell = typename dealii::DoFHandler<dim>::active_cell_iterator;

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

/// Whether a cell is longer than half of the radius of a notch that it bounds. The stress there
/// changes over lengths like that radius, in 3-D along the notch as well: between the nodes of such
/// a cell it may have a maximum that none of them shows.
template <int dim>
bool may_hide_maximum(const StressCell<dim>& cell) {
  constexpr double most = 0.5;
  constexpr double slack = 1e-3;
  if constexpr (dim == 3) {
    const auto faces = cell->face_indices();
    return cell->at_boundary() && std::any_of(faces.begin(), faces.end(), [&](const auto face) {
             return is_round(cell->face(face)) &&
                    length_over_notch_radius(cell, face) > (1. + slack) * most;
           });
  }
  return false;  // chords of rounds are short in the plane
}

/// Whether such a cell is at a node.
template <int dim>
bool may_hide_maximum(const NodalStress<dim>& stress, const Candidate<dim>& node) {
  const unsigned int vertex = node.cell->vertex_index(node.vertex);
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (cell->is_artificial()) continue;
    const auto vertices = cell->vertex_indices();
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&](const auto i) { return cell->vertex_index(i) == vertex; }) &&
        may_hide_maximum<dim>(cell))
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
  maximum.may_be_hidden =
      has_contact(solution.problem) && maximum.is_round && may_hide_maximum(stress, node);
  if constexpr (dim == 2)
    move_to_top(maximum, beside(stress, node, measure), solution.scales.length);
  return maximum;
}

/// Where maxima are looked for.
template <int dim>
class Outside {
 public:
  Outside(const Solution<dim>& solution, const std::vector<SingularPlace<dim>>& singular)
      : own_field_(solution), singular_(singular) {}

  /// @param von_mises [Pa], at the place [m]
  bool operator()(const Point<dim>& place, const unsigned int body, const double von_mises,
                  const double share) const {
    return own_field_.von_mises(place, body) < share * von_mises && !is_beside(singular_, place);
  }

  /// By the cell's middle and its nodes' maximum.
  bool operator()(const Solution<dim>& solution, const NodalStress<dim>& stress,
                  const StressCell<dim>& cell) const {
    return (*this)(Point<dim>(cell->center() * solution.scales.length), cell->material_id(),
                   maximum_von_mises(stress, cell), OwnFieldShare::usual);
  }

 private:
  ContactsOwnField<dim> own_field_;
  const std::vector<SingularPlace<dim>>& singular_;
};

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
                           const std::vector<Candidate<dim>>& nodes, const Outside<dim>& is_outside,
                           const Measure measure, const double share) {
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
                              const Outside<dim>& is_outside, const unsigned int body,
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

/// The variation over this rank's cells of a body outside of the contacts' own field [Pa].
template <int dim>
double maximum_variation(const Solution<dim>& solution, const NodalStress<dim>& stress,
                         const Outside<dim>& is_outside, const unsigned int body) {
  double maximum = 0.;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->material_id() != body) continue;
    const double varying = variation(stress, cell);
    if (varying > maximum && is_outside(solution, stress, cell)) maximum = varying;
  }
  return dealii::Utilities::MPI::max(maximum, solution.dof_handler->get_communicator());
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
  const Outside<dim> is_outside(solution, singular);
  std::vector<BodyStrength<dim>> result;
  for (unsigned int body = 0; body < solution.problem.bodies.size(); ++body) {
    if (solution.problem.bodies[body].is_cut_out) {
      result.emplace_back();
      continue;
    }
    BodyStrength<dim> found{maximum_of(solution, stress, is_outside, body, Measure::von_mises),
                            maximum_of(solution, stress, is_outside, body, Measure::tensile)};
    if (has_contact(solution.problem))
      add_left_by_cells(found, maximum_variation(solution, stress, is_outside, body));
    else
      for (StressMaximum<dim>* const maximum : {&found.von_mises, &found.tensile})
        maximum->open = open_by_cells(solution, stress, singular, body, *maximum);
    result.push_back(found);
  }
  return result;
}

namespace {

/// Up to which distance from nodes in contact a cell is left to the contact: two of its diameters.
/// In 3-D cells are long along the contact: two of a cube with their shortest edge, or half of
/// their length, as far as a node of the other side may be.
template <int dim>
double reach_of_contact(const StressCell<dim>& cell) {
  constexpr double near = 2.;
  if constexpr (dim == 2) return near * cell->diameter();
  double longest = 0.;
  for (const unsigned int line : cell->line_indices())
    longest = std::max(longest, cell->line(line)->diameter());
  return std::max(near * std::sqrt(3.) * cell->minimum_vertex_distance(), longest / 2.);
}

/// Whether a node in contact is near a cell: in the plane its middle, in 3-D one of its corners.
template <int dim>
bool is_near_contact(const Solution<dim>& solution, const StressCell<dim>& cell) {
  std::vector<Point<dim>> places;
  if (dim == 2)
    places.push_back(cell->center());
  else
    for (const unsigned int vertex : cell->vertex_indices()) places.push_back(cell->vertex(vertex));
  const double reach = reach_of_contact<dim>(cell) * solution.scales.length;
  const auto is_near = [&](const ContactNode<dim>& node) {
    return is_closed(node.status) &&
           std::any_of(places.begin(), places.end(), [&](const Point<dim>& place) {
             double square = 0.;
             for (unsigned int i = 0; i < dim; ++i)
               square += std::pow(node.position[i] - solution.scales.length * place[i], 2);
             return square < reach * reach;
           });
  };
  return std::any_of(solution.contacts.begin(), solution.contacts.end(),
                     [&](const ContactResult<dim>& contact) {
                       return std::any_of(contact.nodes.begin(), contact.nodes.end(), is_near);
                     });
}

/// Whether a cell bounds a contact surface near nodes in contact: the contact's refinement keeps
/// its faces even. Not farther: a slot's wall ends at its bottom, where the maximum may be.
template <int dim>
bool belongs_to_contact(const Solution<dim>& solution, const StressCell<dim>& cell) {
  if (!cell->at_boundary()) return false;
  const auto is_of_pair = [&](const unsigned int face) {
    if (!cell->face(face)->at_boundary()) return false;
    const std::string& name = solution.mesh.surfaces[cell->face(face)->boundary_id()];
    return std::any_of(
        solution.problem.pairs.begin(), solution.problem.pairs.end(),
        [&](const ContactPair& pair) { return name == pair.source || name == pair.target; });
  };
  const auto faces = cell->face_indices();
  if (std::none_of(faces.begin(), faces.end(), is_of_pair)) return false;
  return is_near_contact(solution, cell);
}

/// Whether a cell may hide a maximum and has a node outside of the contacts' own field with more
/// than half of a body's maximum.
template <int dim>
bool hides_high_stress(const NodalStress<dim>& stress, const BodyStrength<dim>& body,
                       const Outside<dim>& is_outside, const double length,
                       const StressCell<dim>& cell) {
  constexpr double high = 0.5;
  const auto vertices = cell->vertex_indices();
  const auto is_high = [&](const unsigned int vertex) {
    const auto value = [&](const Measure measure) {
      return measured<dim>(stress.values, cell, vertex, measure);
    };
    const double von_mises = value(Measure::von_mises);
    return (von_mises > high * body.von_mises.value ||
            (body.tensile.value > 0. && value(Measure::tensile) > high * body.tensile.value)) &&
           is_outside(Point<dim>(length * cell->vertex(vertex)), cell->material_id(), von_mises,
                      OwnFieldShare::usual);
  };
  return dim == 3 && cell->at_boundary() &&
         std::any_of(vertices.begin(), vertices.end(), is_high) && may_hide_maximum<dim>(cell);
}

/// Share of the greatest variation over a cell above which cells are halved. Errors go with its
/// square, so that the root of accuracy over error is left; to less than a half one mesh cannot
/// lower it.
template <int dim>
double share_to_halve(const BodyStrength<dim>& body, const double accuracy) {
  return std::clamp(std::sqrt(accuracy / std::max(body.von_mises.error, body.tensile.error)), 0.5,
                    0.7071);
}

}  // namespace

template <int dim>
unsigned int flag_for_strength(const Solution<dim>& solution, const NodalStress<dim>& stress,
                               const std::vector<SingularPlace<dim>>& singular,
                               const std::vector<bool>& of_body, const double most_share,
                               const double accuracy) {
  const Outside<dim> is_outside(solution, singular);
  std::vector<double> limits(of_body.size(), std::numeric_limits<double>::max());
  for (unsigned int body = 0; body < of_body.size(); ++body)
    if (of_body[body])
      limits[body] = std::min(most_share * solution.strength[body].von_mises.value,
                              share_to_halve(solution.strength[body], accuracy) *
                                  maximum_variation(solution, stress, is_outside, body));
  unsigned int flagged = 0;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    const unsigned int body = cell->material_id();
    if (!cell->is_locally_owned() || !of_body[body] || cell->refine_flag_set() ||
        cell->level() >= deepest_level<dim>)
      continue;
    const bool varies =
        variation(stress, cell) > limits[body] && is_outside(solution, stress, cell);
    if (!varies && !hides_high_stress(stress, solution.strength[body], is_outside,
                                      solution.scales.length, cell))
      continue;
    if (belongs_to_contact(solution, cell)) continue;
    cell->set_refine_flag();
    ++flagged;
  }
  return dealii::Utilities::MPI::sum(flagged, solution.dof_handler->get_communicator());
}

#define INSTANTIATE(dim)                                                                          \
  template std::vector<BodyStrength<dim>> strength(const Solution<dim>&, const NodalStress<dim>&, \
                                                   const std::vector<SingularPlace<dim>>&);       \
  template unsigned int flag_for_strength(const Solution<dim>&, const NodalStress<dim>&,          \
                                          const std::vector<SingularPlace<dim>>&,                 \
                                          const std::vector<bool>&, double, double);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace geneva::fem
