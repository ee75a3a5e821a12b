#include "fem/contacts_own_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/elasticity/invariants.h"

namespace geneva::fem {

namespace {

/// The bodies that a contact's surfaces bound, indices into Problem::bodies.
template <int dim>
std::set<unsigned int> bodies_of(const mesh::MeshData<dim>& mesh,
                                 const ContactResult<dim>& contact) {
  std::set<unsigned int> bodies;
  for (const std::string& surface : {contact.source, contact.target})
    bodies.merge(mesh::bodies_of(mesh, mesh::index_of(mesh.surfaces, surface)));
  return bodies;
}

}  // namespace

template <int dim>
ContactsOwnField<dim>::ContactsOwnField(const Solution<dim>& solution)
    : is_line_(dim == 2 && solution.problem.plane != PlaneKind::axisymmetric) {
  for (const Body<dim>& body : solution.problem.bodies)
    along_thickness_.push_back(is_line_ && solution.problem.plane == PlaneKind::plane_strain
                                   ? body.material.poissons_ratio
                                   : 0.);
  const double thickness = is_line_ ? solution.problem.thickness : 1.;
  for (const ContactResult<dim>& contact : solution.contacts) {
    std::vector<PointForce> of_contact;
    for (const ContactNode<dim>& node : contact.nodes) {
      if (!is_closed(node.status)) continue;
      of_contact.push_back({{}, node.pressure * node.tributary / thickness});
      for (unsigned int i = 0; i < dim; ++i) of_contact.back().place[i] = node.position[i];
    }
    if (of_contact.empty()) continue;
    contacts_.push_back({bodies_of(solution.mesh, contact), gathered_up(std::move(of_contact))});
  }
}

/// So that a field takes the same time however many nodes there are: the forces of neighbours along
/// the contact's longest extent as one in their middle.
template <int dim>
std::vector<typename ContactsOwnField<dim>::PointForce> ContactsOwnField<dim>::gathered_up(
    std::vector<PointForce> forces) {
  constexpr std::size_t most = 64;
  if (forces.size() <= most) return forces;
  unsigned int longest = 0;
  double extent = 0.;
  for (unsigned int axis = 0; axis < dim; ++axis) {
    const auto [low, high] = std::minmax_element(
        forces.begin(), forces.end(),
        [&](const auto& a, const auto& b) { return a.place[axis] < b.place[axis]; });
    const double along = high->place[axis] - low->place[axis];
    if (along > extent) longest = axis;
    extent = std::max(extent, along);
  }
  std::sort(forces.begin(), forces.end(),
            [&](const auto& a, const auto& b) { return a.place[longest] < b.place[longest]; });
  std::vector<PointForce> groups(most, {{}, 0.});
  for (std::size_t i = 0; i < forces.size(); ++i) {
    PointForce& group = groups[i * most / forces.size()];
    group.size += forces[i].size;
    group.place += forces[i].size * forces[i].place;
  }
  for (PointForce& group : groups)
    if (group.size > 0.) group.place /= group.size;
  return groups;
}

template <int dim>
double ContactsOwnField<dim>::von_mises(const dealii::Point<dim>& place,
                                        const unsigned int body) const {
  static const double pi = std::acos(-1.);
  // 2/pi sqrt(1 - nu + nu^2) P/r of a line force over 3/2 P/r, the sum of its parts' sizes
  constexpr double of_a_line = 0.4;
  dealii::SymmetricTensor<2, 3> stress;
  double sum = 0.;
  const bool is_pressed =
      std::any_of(contacts_.begin(), contacts_.end(),
                  [&](const ContactForces& contact) { return contact.bodies.count(body) > 0; });
  for (const ContactForces& contact : contacts_) {
    if (is_pressed && contact.bodies.count(body) == 0) continue;
    for (const PointForce& force : contact.forces) {
      const dealii::Tensor<1, dim> radius = place - force.place;
      const double r = std::max(radius.norm(), 1e-300);
      const double radial =
          is_line_ ? 2. * force.size / (pi * r) : 3. * force.size / (2. * pi * r * r);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          stress[i][j] -= radial * radius[i] * radius[j] / (r * r);
      sum += radial;
    }
  }
  if (is_line_) stress[2][2] = along_thickness_[body] * (stress[0][0] + stress[1][1]);
  return std::max(fem::von_mises(principal_stresses(stress)), (is_line_ ? 1. : of_a_line) * sum);
}

template class ContactsOwnField<2>;
template class ContactsOwnField<3>;

}  // namespace geneva::fem
