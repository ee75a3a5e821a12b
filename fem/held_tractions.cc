#include "fem/held_tractions.h"

#include <cmath>

#include "fem/elasticity/elasticity.h"

namespace geneva::fem {

namespace {

using dealii::Point;

/// Measure of an edge that belongs to one of its ends: integral of N over it.
double share_of_end(const Point<2>& here, const Point<2>& there, const Problem<2>& problem) {
  const Point<2> nearer = here + (there - here) / 3.;  // N is linear as the radius is
  return 0.5 * here.distance(there) * out_of_plane_measure(problem, nearer);
}

/// An edge of a circle stands for its arc: arc / chord.
double arc_over_chord(const double chord, const mesh::Circle& circle) {
  const double half = 0.5 * chord / circle.radius;
  return half < 1. ? std::asin(half) / half : 1.;
}

std::array<double, 2> shares_of_face(const Boundary<2>& boundary, const BoundaryFace<2>& face,
                                     const Problem<2>& problem) {
  const Point<2>& start = boundary.nodes[face.nodes[0]].position;
  const Point<2>& end = boundary.nodes[face.nodes[1]].position;
  const double stretch =
      face.circle < 0 ? 1.
                      : arc_over_chord(start.distance(end),
                                       boundary.circles[static_cast<std::size_t>(face.circle)]);
  return {stretch * share_of_end(start, end, problem), stretch * share_of_end(end, start, problem)};
}

/// Of a bilinear quadrilateral, by two Gauss points each way.
std::array<double, 4> shares_of_face(const Boundary<3>& boundary, const BoundaryFace<3>& face,
                                     const Problem<3>&) {
  const auto corner = [&](const std::size_t i) { return boundary.nodes[face.nodes[i]].position; };
  const double low = 0.5 - 0.5 / std::sqrt(3.);
  std::array<double, 4> shares{};
  for (const double s : {low, 1. - low})
    for (const double t : {low, 1. - low}) {
      const auto along = (1. - t) * (corner(1) - corner(0)) + t * (corner(2) - corner(3));
      const auto across = (1. - s) * (corner(3) - corner(0)) + s * (corner(2) - corner(1));
      const double weight = 0.25 * dealii::cross_product_3d(along, across).norm();
      const std::array<double, 4> shape{(1. - s) * (1. - t), s * (1. - t), s * t, (1. - s) * t};
      for (std::size_t i = 0; i < shares.size(); ++i) shares[i] += shape[i] * weight;
    }
  return shares;
}

/// Calls visit(dof, whether it is held, its share of the face) for the dofs of faces that are held.
template <int dim, typename Visit>
void visit_dofs(const Boundary<dim>& boundary, const Problem<dim>& problem,
                const HeldComponents<dim>& held, const Visit& visit) {
  for (const BoundaryFace<dim>& face : boundary.faces) {
    const auto components = held.find(face.surface);
    if (components == held.end()) continue;
    const auto shares = shares_of_face(boundary, face, problem);
    for (std::size_t i = 0; i < shares.size(); ++i)
      for (std::size_t c = 0; c < components->second.size(); ++c)
        visit(boundary.nodes[face.nodes[i]].dofs[c], components->second[c], shares[i]);
  }
}

}  // namespace

template <int dim>
std::map<global_dof_index, double> held_tractions(
    const Boundary<dim>& boundary, const Problem<dim>& problem, const HeldComponents<dim>& held,
    const std::vector<ConstraintLine>& hanging_lines,
    const std::function<double(global_dof_index)>& force) {
  std::map<global_dof_index, double> shares;
  visit_dofs(boundary, problem, held,
             [&](const global_dof_index dof, const bool is_held, const double share) {
               shares[dof] += is_held ? share : 0.;
             });
  for (const ConstraintLine& line : hanging_lines) {
    const auto hanging = shares.find(line.dof);
    if (hanging == shares.end()) continue;
    for (const auto& [dof, part] : line.entries) {
      const auto carrier = shares.find(dof);
      if (carrier != shares.end()) carrier->second += part * hanging->second;
    }
    shares.erase(hanging);
  }
  std::map<global_dof_index, double> tractions;
  for (const auto& [dof, share] : shares) tractions[dof] = share > 0. ? force(dof) / share : 0.;
  return tractions;
}

template std::map<global_dof_index, double> held_tractions(
    const Boundary<2>&, const Problem<2>&, const HeldComponents<2>&,
    const std::vector<ConstraintLine>&, const std::function<double(global_dof_index)>&);
template std::map<global_dof_index, double> held_tractions(
    const Boundary<3>&, const Problem<3>&, const HeldComponents<3>&,
    const std::vector<ConstraintLine>&, const std::function<double(global_dof_index)>&);

}  // namespace geneva::fem
