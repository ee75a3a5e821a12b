#include "fem/strength_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fem/discretisation/refined_mesh.h"
#include "fem/outside_of_contact.h"
#include "fem/stress_error.h"
#include "fem/stress_variation.h"

namespace geneva::fem {

using dealii::Point;

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
/// than half of a body's maximum that is not minor.
bool hides_high_stress(const Solution<3>& solution, const NodalStress<3>& stress,
                       const OutsideOfContact<3>& is_outside, const StressCell<3>& cell) {
  const BodyStrength<3>& body = solution.strength[cell->material_id()];
  constexpr double high = 0.5;
  const auto vertices = cell->vertex_indices();
  const auto is_high = [&](const unsigned int vertex) {
    const auto value = [&](const Measure measure) {
      return measured<3>(stress.values, cell, vertex, measure);
    };
    const double von_mises = value(Measure::von_mises);
    return (von_mises > high * body.von_mises.value ||
            (body.tensile.value > 0. && !body.tensile.is_minor &&
             value(Measure::tensile) > high * body.tensile.value)) &&
           is_outside(Point<3>(solution.scales.length * cell->vertex(vertex)), cell->material_id(),
                      von_mises, OwnFieldShare::usual);
  };
  return cell->at_boundary() && std::any_of(vertices.begin(), vertices.end(), is_high) &&
         may_hide_maximum(solution, cell);
}

/// Share of the greatest variation over a cell above which cells are halved. Errors go with its
/// square, so that the root of accuracy over error is left; to less than a half one mesh cannot
/// lower it.
double share_to_halve(const BodyStrength<2>& body, const double accuracy) {
  return std::clamp(std::sqrt(accuracy / std::max(body.von_mises.error, body.tensile.error)), 0.5,
                    0.7071);
}

/// Share of what is open that the next mesh must take for the accuracy and a reserve, since halved
/// cells still leave a quarter. Meshes for the contact take at most a half, for there are more of
/// them; one that is made for the maxima alone costs a whole solve, and takes more.
double share_to_refine(const std::vector<const StressMaximum<3>*>& wanted, const double accuracy,
                       const MeshFor next) {
  constexpr double closed = 0.75;
  constexpr double reserve = 0.3;
  double error = 0.;
  for (const StressMaximum<3>* const maximum : wanted) error = std::max(error, maximum->error);
  const double share = (1. - (1. - reserve) * accuracy / error) / closed;
  return next == MeshFor::stresses ? std::clamp(share, 0.5, 0.95) : std::clamp(share, 0.1, 0.75);
}

}  // namespace

unsigned int flag_in_plane(const Solution<2>& solution, const NodalStress<2>& stress,
                           const std::vector<SingularPlace<2>>& singular,
                           const WantedMaxima<2>& wanted, const double most_share,
                           const double accuracy) {
  const OutsideOfContact<2> is_outside(solution, singular);
  std::vector<double> limits(wanted.size(), std::numeric_limits<double>::max());
  for (unsigned int body = 0; body < wanted.size(); ++body)
    if (!wanted[body].empty())
      limits[body] = std::min(most_share * solution.strength[body].von_mises.value,
                              share_to_halve(solution.strength[body], accuracy) *
                                  maximum_variation(stress, is_outside, body));
  unsigned int flagged = 0;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    const unsigned int body = cell->material_id();
    if (!cell->is_locally_owned() || wanted[body].empty() || cell->refine_flag_set() ||
        cell->level() >= deepest_level<2>)
      continue;
    const bool varies = variation(stress, cell) > limits[body] && is_outside(stress, cell);
    if (!varies || belongs_to_contact(solution, cell)) continue;
    cell->set_refine_flag();
    ++flagged;
  }
  return dealii::Utilities::MPI::sum(flagged, solution.dof_handler->get_communicator());
}

unsigned int flag_in_space(const Solution<3>& solution, const NodalStress<3>& stress,
                           const std::vector<SingularPlace<3>>& singular,
                           const WantedMaxima<3>& wanted, const double accuracy,
                           const MeshFor next) {
  const OutsideOfContact<3> is_outside(solution, singular);
  const auto may_be_finer = [&](const StressCell<3>& cell) {
    return !wanted[cell->material_id()].empty() && !cell->refine_flag_set() &&
           !belongs_to_contact(solution, cell);
  };
  unsigned int hiding = 0;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->level() >= deepest_level<3> || !may_be_finer(cell) ||
        !hides_high_stress(solution, stress, is_outside, cell))
      continue;
    cell->set_refine_flag();
    ++hiding;
  }
  unsigned int flagged =
      dealii::Utilities::MPI::sum(hiding, solution.dof_handler->get_communicator());
  if (next == MeshFor::unknown_contact) return flagged;
  for (unsigned int body = 0; body < wanted.size(); ++body)
    if (!wanted[body].empty())
      flagged += flag_open<3>(
          solution, stress, is_outside, wanted,
          [&](const StressCell<3>& cell) {
            return cell->material_id() == body && may_be_finer(cell) && is_outside(stress, cell);
          },
          share_to_refine(wanted[body], accuracy, next));
  return flagged;
}

}  // namespace geneva::fem
