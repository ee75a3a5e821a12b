#include "fem/contacts_own_field.h"

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

template <int dim>
std::vector<ContactNode<dim>> closed_nodes(const ContactResult<dim>& contact) {
  std::vector<ContactNode<dim>> closed;
  std::copy_if(contact.nodes.begin(), contact.nodes.end(), std::back_inserter(closed),
               [](const ContactNode<dim>& node) { return is_closed(node.status); });
  return closed;
}

template <int dim>
std::vector<dealii::Point<dim>> places_of(const std::vector<ContactNode<dim>>& nodes) {
  std::vector<dealii::Point<dim>> places(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (unsigned int axis = 0; axis < dim; ++axis) places[i][axis] = nodes[i].position[axis];
  return places;
}

/// How far places reach along an axis [m].
struct Extent {
  unsigned int axis = 0;
  double low = 0.;
  double high = 0.;

  [[nodiscard]] double length() const { return high - low; }
};

template <int dim>
Extent extent_along(const std::vector<dealii::Point<dim>>& places, const unsigned int axis) {
  const auto [low, high] =
      std::minmax_element(places.begin(), places.end(),
                          [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
  return {axis, (*low)[axis], (*high)[axis]};
}

template <int dim>
Extent longest_extent(const std::vector<dealii::Point<dim>>& places) {
  Extent longest = extent_along(places, 0);
  for (unsigned int axis = 1; axis < dim; ++axis)
    if (const Extent extent = extent_along(places, axis); extent.length() > longest.length())
      longest = extent;
  return longest;
}

template <int dim>
Extent extent_of_body(const mesh::MeshData<dim>& mesh, const unsigned int body,
                      const unsigned int axis) {
  std::vector<dealii::Point<dim>> places;
  for (const mesh::Cell<dim>& cell : mesh.cells) {
    if (cell.body != body) continue;
    for (const unsigned int vertex : cell.vertices) {
      places.emplace_back();
      for (unsigned int i = 0; i < dim; ++i) places.back()[i] = mesh.vertices[vertex][i];
    }
  }
  return extent_along(places, axis);
}

/// Ends of a contact along its longest extent that are those of a body: an edge of its, or a plane
/// of symmetry.
template <int dim>
std::vector<double> ends_at_body(const mesh::MeshData<dim>& mesh, const unsigned int body,
                                 const Extent& contact) {
  constexpr double slack = 1e-3;
  const Extent of_body = extent_of_body(mesh, body, contact.axis);
  std::vector<double> ends;
  if (contact.low - of_body.low <= slack * contact.length()) ends.push_back(contact.low);
  if (of_body.high - contact.high <= slack * contact.length()) ends.push_back(contact.high);
  return ends;
}

/// In 3-D, where cells are long along a contact: places in a row over the length of a node's area,
/// whose width is the distance to the next node.
std::vector<dealii::Point<3>> spread(const ContactNode<3>& node, const dealii::Point<3>& place,
                                     const dealii::Point<3>& next) {
  constexpr double most = 32.;
  const dealii::Tensor<1, 3> across = next - place;
  const double width = across.norm();
  if (width == 0.) return {place};
  const double parts = std::clamp(std::round(node.tributary / (width * width)), 1., most);
  const dealii::Tensor<1, 3> normal({node.normal[0], node.normal[1], node.normal[2]});
  const dealii::Tensor<1, 3> along =
      node.tributary / (width * width) * dealii::cross_product_3d(normal, across);
  std::vector<dealii::Point<3>> places;
  for (int i = 0; i < static_cast<int>(parts); ++i)
    places.push_back(place + ((i + 0.5) / parts - 0.5) * along);
  return places;
}

/// For every node the places at which parts of its force act.
template <int dim>
std::vector<std::vector<dealii::Point<dim>>> spread(const std::vector<ContactNode<dim>>& nodes) {
  const std::vector<dealii::Point<dim>> places = places_of(nodes);
  std::vector<std::vector<dealii::Point<dim>>> result;
  if constexpr (dim == 3) {
    const auto tree = dealii::pack_rtree_of_indices(places);
    for (std::size_t i = 0; i < nodes.size() && nodes.size() > 1; ++i) {
      std::vector<std::size_t> nearest;
      tree.query(boost::geometry::index::nearest(places[i], 2), std::back_inserter(nearest));
      const std::size_t next = nearest[0] == i ? nearest[1] : nearest[0];
      result.push_back(spread(nodes[i], places[i], places[next]));
    }
  }
  for (std::size_t i = result.size(); i < nodes.size(); ++i) result.push_back({places[i]});
  return result;
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
    const std::vector<ContactNode<dim>> nodes = closed_nodes(contact);
    if (nodes.empty()) continue;
    const auto places = spread(nodes);
    std::vector<PointForce> of_contact;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const dealii::Point<dim>& place : places[i])
        of_contact.push_back({place, nodes[i].pressure * nodes[i].tributary / thickness /
                                         static_cast<double>(places[i].size())});
    const std::set<unsigned int> bodies = bodies_of(solution.mesh, contact);
    if (dim == 3) {
      const Extent extent = longest_extent(places_of(nodes));
      for (const unsigned int body : bodies)
        for (const double end : ends_at_body(solution.mesh, body, extent))
          images_.push_back({{body}, groups_of(mirrored(of_contact, extent.axis, end))});
    }
    contacts_.push_back({bodies, groups_of(std::move(of_contact))});
  }
}

template <int dim>
std::vector<typename ContactsOwnField<dim>::PointForce> ContactsOwnField<dim>::mirrored(
    std::vector<PointForce> forces, const unsigned int axis, const double end) {
  for (PointForce& force : forces) force.place[axis] = 2. * end - force.place[axis];
  return forces;
}

template <int dim>
typename ContactsOwnField<dim>::ForceGroup ContactsOwnField<dim>::group_of(
    std::vector<PointForce> forces) {
  ForceGroup group{{{}, 0.}, 0., std::move(forces)};
  for (const PointForce& force : group.forces) {
    group.sum.size += force.size;
    group.sum.place += force.size * force.place;
  }
  if (group.sum.size > 0.) group.sum.place /= group.sum.size;
  for (const PointForce& force : group.forces)
    group.extent = std::max(group.extent, group.sum.place.distance(force.place));
  return group;
}

/// So that a field far away takes the same time however many nodes there are: neighbours along the
/// contact's longest extent.
template <int dim>
std::vector<typename ContactsOwnField<dim>::ForceGroup> ContactsOwnField<dim>::groups_of(
    std::vector<PointForce> forces) {
  constexpr std::size_t most = 64;
  std::vector<dealii::Point<dim>> places;
  for (const PointForce& force : forces) places.push_back(force.place);
  const unsigned int longest = longest_extent(places).axis;
  std::sort(forces.begin(), forces.end(),
            [&](const auto& a, const auto& b) { return a.place[longest] < b.place[longest]; });
  std::vector<ForceGroup> groups;
  const std::size_t n_groups = std::min(most, forces.size());
  for (std::size_t i = 0; i < n_groups; ++i) {
    const auto bound = [&](const std::size_t group) {
      return forces.begin() + static_cast<std::ptrdiff_t>(group * forces.size() / n_groups);
    };
    groups.push_back(group_of({bound(i), bound(i + 1)}));
  }
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
  const auto add = [&](const PointForce& force) {
    const dealii::Tensor<1, dim> radius = place - force.place;
    const double r = std::max(radius.norm(), 1e-100);
    const double radial =
        is_line_ ? 2. * force.size / (pi * r) : 3. * force.size / (2. * pi * r * r);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        stress[i][j] -= radial * radius[i] * radius[j] / (r * r);
    sum += radial;
  };
  constexpr double far = 2.;  // the sum's stress is off by a quarter of itself there at most
  const bool is_pressed =
      std::any_of(contacts_.begin(), contacts_.end(),
                  [&](const ContactForces& contact) { return contact.bodies.count(body) > 0; });
  const auto add_contact = [&](const ContactForces& contact) {
    for (const ForceGroup& group : contact.groups)
      if (place.distance(group.sum.place) > far * group.extent)
        add(group.sum);
      else
        std::for_each(group.forces.begin(), group.forces.end(), add);
  };
  for (const ContactForces& contact : contacts_)
    if (!is_pressed || contact.bodies.count(body) > 0) add_contact(contact);
  for (const ContactForces& image : images_)
    if (image.bodies.count(body) > 0) add_contact(image);
  if (is_line_) stress[2][2] = along_thickness_[body] * (stress[0][0] + stress[1][1]);
  return std::max(fem::von_mises(principal_stresses(stress)), (is_line_ ? 1. : of_a_line) * sum);
}

template class ContactsOwnField<2>;
template class ContactsOwnField<3>;

}  // namespace geneva::fem
