#include "fem/boundary_stress.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fem/contact/surface.h"
#include "fem/discretisation/round_cell.h"
#include "fem/elasticity/surface_stress.h"

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

/// A boundary face, seen from one of its vertices.
template <int dim>
struct BoundaryFaceThere {
  Tensor<1, dim> normal;                   ///< of the true surface at the vertex, outward
  Tensor<1, dim> inwards;                  ///< from the vertex to the face's middle
  bool is_held;                            ///< by a support or tie
  std::optional<Tensor<1, dim>> traction;  ///< [Pa], if it is known
  typename dealii::DoFHandler<dim>::active_cell_iterator cell;  ///< that it bounds
  std::vector<unsigned int> corners;                            ///< vertices of that cell
  std::vector<unsigned int> vertices;                           ///< of the mesh
};

namespace {

/// Share of the difference between the two recoveries at a free surface by which the better one is
/// off: at Kirsch's hole 0.16 to 0.24, with 16 to 128 cells around it; at slot bottoms up to 0.84,
/// on coarse cells.
constexpr double share_at_surface = 0.85;
/// Faces whose normals differ by less are one smooth surface.
constexpr double cosine_of_smooth = 0.95;

template <int dim>
bool is_smooth(const std::vector<BoundaryFaceThere<dim>>& faces) {
  return std::all_of(faces.begin(), faces.end(), [&](const auto& face) {
    return face.normal * faces.front().normal > cosine_of_smooth;
  });
}

/// Whether faces that meet at a vertex have in the plane it, in 3-D an edge in common.
template <int dim>
bool are_neighbours(const BoundaryFaceThere<dim>& one, const BoundaryFaceThere<dim>& other) {
  return std::count_if(one.vertices.begin(), one.vertices.end(), [&](const unsigned int vertex) {
           return std::find(other.vertices.begin(), other.vertices.end(), vertex) !=
                  other.vertices.end();
         }) >= dim - 1;
}

/// Whether the body sticks out between the faces that meet at a vertex.
template <int dim>
bool is_convex(const std::vector<BoundaryFaceThere<dim>>& faces) {
  for (const BoundaryFaceThere<dim>& one : faces)
    for (const BoundaryFaceThere<dim>& other : faces)
      if (are_neighbours(one, other) && one.normal * other.normal <= cosine_of_smooth &&
          one.normal * other.inwards > 1e-6 * other.inwards.norm())
        return false;
  return true;
}

/// (1 - n n) stress (1 - n n)
template <int dim>
StressVector<dim> without_traction(const StressVector<dim>& stress, const Tensor<1, dim>& normal) {
  const Tensor<1, dim> traction = traction_of<dim>(stress, normal);
  const double along = traction * normal;
  const auto component = [&](const unsigned int i, const unsigned int j) {
    return normal[i] * traction[j] + traction[i] * normal[j] - along * normal[i] * normal[j];
  };
  StressVector<dim> result = stress;
  for (unsigned int i = 0; i < dim; ++i) result[i] -= component(i, i);
  result[3] -= component(0, 1);
  if constexpr (dim == 3) {
    result[4] -= component(0, 2);
    result[5] -= component(1, 2);
  }
  return result;
}

/// Normal of a face, not of the unit length, in either direction.
template <typename Face>
Tensor<1, Face::AccessorType::space_dimension> normal_of(const Face& face) {
  if constexpr (Face::AccessorType::space_dimension == 2)
    return dealii::cross_product_2d(Tensor<1, 2>(face->vertex(1) - face->vertex(0)));
  else
    return dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                    face->vertex(2) - face->vertex(1));
}

}  // namespace

template <int dim>
BoundaryStress<dim>::BoundaryStress(const Vector& displacement, const Problem<dim>& problem,
                                    const BoundaryTractions<dim>& tractions)
    : displacement_(displacement),
      problem_(problem),
      tractions_(tractions),
      laws_(material_laws(problem)) {}

/// An axis of revolution is a plane of symmetry in every section through it.
template <int dim>
std::optional<unsigned int> BoundaryStress<dim>::mirror_axis(const Cell& cell,
                                                             const unsigned int face) const {
  const SurfaceTraction<dim>& surface = tractions_.surfaces[cell->face(face)->boundary_id()];
  if (surface.kind == TractionKind::mirrored) return surface.axis;
  if (dim == 2 && problem_.plane == PlaneKind::axisymmetric &&
      std::abs(cell->face(face)->center()[0]) <= 1e-12)
    return 0;
  return std::nullopt;
}

template <int dim>
std::vector<Mirror> BoundaryStress<dim>::mirrors_at(const std::vector<Corner>& corners) const {
  std::map<unsigned int, double> places;
  for (const Corner& corner : corners) {
    const Cell& cell = corner.cell;
    if (!cell->at_boundary()) continue;
    for (unsigned int k = 0; k < dim; ++k) {
      // the face normal to the reference axis k that the vertex lies on
      const unsigned int face = 2 * k + ((corner.vertex >> k) & 1U);
      if (!cell->face(face)->at_boundary()) continue;
      if (const auto axis = mirror_axis(cell, face))
        places[*axis] = cell->vertex(corner.vertex)[*axis];
    }
  }
  std::vector<Mirror> mirrors;
  for (const auto& [axis, place] : places) mirrors.push_back({axis, place});
  return mirrors;
}

template <int dim>
RecoveredStress<dim> BoundaryStress<dim>::at(const std::vector<Corner>& corners,
                                             const RecoveredStress<dim>& linear) const {
  const StressVector<dim>& inside = linear.stress;
  const std::vector<BoundaryFaceThere<dim>> faces = faces_at(corners);
  const auto is_held = [](const auto& face) { return face.is_held; };
  const bool is_at_end_of_support = std::any_of(faces.begin(), faces.end(), is_held) &&
                                    !std::all_of(faces.begin(), faces.end(), is_held);
  if (is_at_end_of_support || !std::all_of(faces.begin(), faces.end(), [](const auto& face) {
        return face.traction.has_value();
      }))
    return linear;
  if (is_smooth(faces)) {
    const auto found = stress_on(corners, faces);
    return found ? RecoveredStress<dim>{*found, share_at_surface * (*found - inside)} : linear;
  }
  if (!is_convex(faces)) return linear;
  StressVector<dim> stress = inside;
  for (const BoundaryFaceThere<dim>& face : faces) {
    if (face.traction->norm() > 0.) return linear;
    stress = without_traction<dim>(stress, face.normal);
  }
  return {stress, share_at_surface * (stress - inside)};
}

template <int dim>
Tensor<1, dim> BoundaryStress<dim>::displacement_of(const Corner& corner) const {
  Tensor<1, dim> result;
  for (unsigned int i = 0; i < dim; ++i)
    result[i] = displacement_(corner.cell->vertex_dof_index(corner.vertex, i));
  return result;
}

/// Nodes nearer than a face and a half may carry a part of its force.
template <int dim>
bool BoundaryStress<dim>::carries_contact(const Point<dim>& place, const double face_size) const {
  return std::any_of(
      tractions_.in_contact.begin(), tractions_.in_contact.end(),
      [&](const Point<dim>& node) { return node.distance(place) < 1.5 * face_size; });
}

/// @return nothing if the force at the node is not known
template <int dim>
std::optional<Tensor<1, dim>> BoundaryStress<dim>::held_traction(const Corner& corner) const {
  Tensor<1, dim> traction;
  for (unsigned int i = 0; i < dim; ++i) {
    const auto found = tractions_.at_held.find(corner.cell->vertex_dof_index(corner.vertex, i));
    if (found == tractions_.at_held.end()) return std::nullopt;
    traction[i] = found->second;
  }
  return traction;
}

template <int dim>
BoundaryFaceThere<dim> BoundaryStress<dim>::face_there(const Corner& corner,
                                                       const unsigned int face) const {
  const Cell& cell = corner.cell;
  const auto surface = cell->face(face);
  const Point<dim> place = cell->vertex(corner.vertex);
  BoundaryFaceThere<dim> there;
  const Tensor<1, dim> flat = normal_of(surface);
  const Tensor<1, dim> outwards = surface->center() - cell->center();
  there.normal =
      is_round(surface) ? radial(tractions_.circles[surface->manifold_id() - 1], place) : flat;
  there.normal /= there.normal.norm();
  if (there.normal * flat * (flat * outwards) < 0.) there.normal = -there.normal;
  there.inwards = surface->center() - place;
  const SurfaceTraction<dim>& load = tractions_.surfaces[surface->boundary_id()];
  there.is_held = load.kind == TractionKind::held;
  if (there.is_held)
    there.traction = held_traction(corner);
  else if (load.kind == TractionKind::given ||
           (load.kind == TractionKind::contact && !carries_contact(place, surface->diameter())))
    there.traction.emplace();
  if (there.traction)
    for (unsigned int i = 0; i < dim; ++i)
      (*there.traction)[i] += load.traction[i] - load.pressure * there.normal[i];
  for (const unsigned int i : surface->vertex_indices())
    there.corners.push_back(dealii::GeometryInfo<dim>::face_to_cell_vertices(face, i));
  for (const unsigned int vertex : there.corners)
    there.vertices.push_back(cell->vertex_index(vertex));
  there.cell = corner.cell;
  return there;
}

template <int dim>
std::vector<BoundaryFaceThere<dim>> BoundaryStress<dim>::faces_at(
    const std::vector<Corner>& corners) const {
  std::vector<BoundaryFaceThere<dim>> faces;
  for (const Corner& corner : corners) {
    const Cell& cell = corner.cell;
    for (unsigned int k = 0; k < dim; ++k) {
      const unsigned int face = 2 * k + ((corner.vertex >> k) & 1U);
      if (cell->face(face)->at_boundary() && !mirror_axis(cell, face))
        faces.push_back(face_there(corner, face));
    }
  }
  return faces;
}

/// On a smooth surface, from the strains along it and the traction.
/// @return nothing if the nodes around do not determine the strains
template <int dim>
std::optional<StressVector<dim>> BoundaryStress<dim>::stress_on(
    const std::vector<Corner>& corners, const std::vector<BoundaryFaceThere<dim>>& faces) const {
  const Cell& cell = corners.front().cell;
  const Point<dim> place = cell->vertex(corners.front().vertex);
  const Tensor<1, dim> here = displacement_of(corners.front());
  Tensor<1, dim> normal;
  Tensor<1, dim> traction;
  std::map<unsigned int, SurfaceNeighbour<dim>> around;
  for (const BoundaryFaceThere<dim>& face : faces) {
    normal += face.normal;
    traction += *face.traction / static_cast<double>(faces.size());
    for (const unsigned int vertex : face.corners)
      around[face.cell->vertex_index(vertex)] = {face.cell->vertex(vertex) - place,
                                                 displacement_of({face.cell, vertex}) - here};
  }
  around.erase(cell->vertex_index(corners.front().vertex));
  std::vector<SurfaceNeighbour<dim>> neighbours;
  for (const auto& [vertex, neighbour] : around) neighbours.push_back(neighbour);
  for (const Mirror& mirror : mirrors_at(corners)) {
    // what the plane of symmetry exerts is none of the surface's
    if (faces.front().is_held) traction[mirror.axis] = 0.;
    const std::size_t n = neighbours.size();
    for (std::size_t i = 0; i < n; ++i)
      if (std::abs(neighbours[i].offset[mirror.axis]) > 0.)
        neighbours.push_back({mirrored(neighbours[i].offset, mirror.axis),
                              mirrored(neighbours[i].displacement, mirror.axis)});
  }
  normal /= normal.norm();
  const auto gradient = surface_gradient<dim>(normal, neighbours);
  if (!gradient) return std::nullopt;
  double hoop = 0.;
  if (dim == 2 && problem_.plane == PlaneKind::axisymmetric)
    hoop = place[0] > 1e-12 ? here[0] / place[0] : (*gradient)[0][0];
  return surface_stress<dim>(*laws_[cell->material_id()], *gradient, hoop, normal, traction);
}

template class BoundaryStress<2>;
template class BoundaryStress<3>;

}  // namespace geneva::fem
