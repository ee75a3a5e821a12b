#include "fem/stress_recovery.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "fem/contact/surface.h"
#include "fem/discretisation/element.h"
#include "fem/discretisation/round_cell.h"
#include "fem/elasticity/cell_element.h"
#include "fem/elasticity/surface_stress.h"
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

/// A boundary face, seen from one of its vertices.
template <int dim>
struct FaceThere {
  Tensor<1, dim> normal;                   ///< of the true surface at the vertex, outward
  Tensor<1, dim> inwards;                  ///< from the vertex to the face's middle
  bool is_held;                            ///< by a support or tie
  std::optional<Tensor<1, dim>> traction;  ///< [Pa], if it is known
  std::size_t cell;                        ///< that it bounds
  std::vector<unsigned int> corners;       ///< vertices of that cell
  std::vector<unsigned int> vertices;      ///< of the mesh
};

/// Share of the difference between the two recoveries at a free surface by which the better one is
/// off: at Kirsch's hole 0.16 to 0.24, with 16 to 128 cells around it; at slot bottoms up to 0.84,
/// on coarse cells.
constexpr double share_at_surface = 0.85;
/// See doubt_of_linear(). At Kirsch's hole, extrapolated from inside, with 64 cells around it, the
/// error was 1.5 times the relative difference.
constexpr double share_inside = 1.5;
/// Faces whose normals differ by less are one smooth surface.
constexpr double cosine_of_smooth = 0.95;

template <int dim>
bool is_smooth(const std::vector<FaceThere<dim>>& faces) {
  return std::all_of(faces.begin(), faces.end(), [&](const auto& face) {
    return face.normal * faces.front().normal > cosine_of_smooth;
  });
}

/// Whether faces that meet at a vertex have in the plane it, in 3-D an edge in common.
template <int dim>
bool are_neighbours(const FaceThere<dim>& one, const FaceThere<dim>& other) {
  return std::count_if(one.vertices.begin(), one.vertices.end(), [&](const unsigned int vertex) {
           return std::find(other.vertices.begin(), other.vertices.end(), vertex) !=
                  other.vertices.end();
         }) >= dim - 1;
}

/// Whether the body sticks out between the faces that meet at a vertex.
template <int dim>
bool is_convex(const std::vector<FaceThere<dim>>& faces) {
  for (const FaceThere<dim>& one : faces)
    for (const FaceThere<dim>& other : faces)
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

/// See NodalStress.
template <int dim>
struct Recovered {
  StressVector<dim> stress, doubt;
};

template <int dim>
class StressRecovery {
 public:
  StressRecovery(const dealii::DoFHandler<dim>& dof_handler, const Vector& displacement,
                 const Problem<dim>& problem, const BoundaryTractions<dim>& tractions)
      : displaced_(dof_handler),
        displacement_(displacement),
        problem_(problem),
        tractions_(tractions),
        laws_(material_laws(problem)) {}

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
  [[nodiscard]] std::optional<unsigned int> mirror_axis(const Cell& cell, unsigned int face) const;
  [[nodiscard]] std::vector<Mirror> mirrors_at(const std::vector<Corner>& corners) const;
  [[nodiscard]] std::vector<Sample<dim>> samples_around(const std::vector<Corner>& corners) const;
  [[nodiscard]] std::vector<Corner> inner_neighbours(const std::vector<Corner>& corners) const;
  [[nodiscard]] Recovered<dim> at_boundary(const std::vector<Corner>& corners,
                                           const StressVector<dim>& inside) const;
  void set(const StressDofs& dofs, const StressVector<dim>& stress, const StressVector<dim>& doubt);
  [[nodiscard]] StressVector<dim> mean_around(const std::vector<Corner>& corners) const;
  [[nodiscard]] StressVector<dim> images_mean(const std::vector<Corner>& corners,
                                              StressVector<dim> stress) const;
  [[nodiscard]] std::vector<FaceThere<dim>> faces_at(const std::vector<Corner>& corners) const;
  [[nodiscard]] FaceThere<dim> face_there(const Corner& corner, unsigned int face) const;
  [[nodiscard]] bool carries_contact(const Point<dim>& place, double face_size) const;
  [[nodiscard]] std::optional<Tensor<1, dim>> held_traction(const Corner& corner) const;
  [[nodiscard]] Tensor<1, dim> displacement_of(const Cell& cell, unsigned int vertex) const;
  [[nodiscard]] std::optional<StressVector<dim>> stress_on(
      const std::vector<Corner>& corners, const std::vector<FaceThere<dim>>& faces) const;

  const dealii::DoFHandler<dim>& displaced_;
  const Vector& displacement_;
  const Problem<dim>& problem_;
  const BoundaryTractions<dim>& tractions_;
  MaterialLaws<dim> laws_;
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

/// An axis of revolution is a plane of symmetry in every section through it.
template <int dim>
std::optional<unsigned int> StressRecovery<dim>::mirror_axis(const Cell& cell,
                                                             const unsigned int face) const {
  const SurfaceTraction<dim>& surface = tractions_.surfaces[cell->face(face)->boundary_id()];
  if (surface.kind == TractionKind::mirrored) return surface.axis;
  if (dim == 2 && problem_.plane == PlaneKind::axisymmetric &&
      std::abs(cell->face(face)->center()[0]) <= 1e-12)
    return 0;
  return std::nullopt;
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
      if (cell->face(face)->at_boundary() && !mirror_axis(cell, face))
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
std::vector<Mirror> StressRecovery<dim>::mirrors_at(const std::vector<Corner>& corners) const {
  std::map<unsigned int, double> places;
  for (const Corner& corner : corners) {
    const Cell& cell = cells_[corner.cell];
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

/// With their images.
template <int dim>
std::vector<Sample<dim>> StressRecovery<dim>::samples_around(
    const std::vector<Corner>& corners) const {
  std::vector<Sample<dim>> samples;
  for (const Corner& corner : corners) samples.push_back(samples_[corner.cell]);
  for (const Mirror& mirror : mirrors_at(corners)) {
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
    const StressVector<dim> inside =
        images_mean(corners, found == extrapolated.end() ? mean_around(corners) : found->second);
    const auto [stress, doubt] = at_boundary(corners, inside);
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
  for (const Mirror& mirror : mirrors_at(corners))
    stress = 0.5 * (stress + mirrored(Sample<dim>{{}, stress}, mirror).stress);
  return stress;
}

/// @param inside extrapolated from there
template <int dim>
Recovered<dim> StressRecovery<dim>::at_boundary(const std::vector<Corner>& corners,
                                                const StressVector<dim>& inside) const {
  const Recovered<dim> linear{inside,
                              doubt_of_linear<dim>(inside, mean_around(corners), share_inside)};
  const std::vector<FaceThere<dim>> faces = faces_at(corners);
  const auto is_held = [](const auto& face) { return face.is_held; };
  const bool is_at_end_of_support = std::any_of(faces.begin(), faces.end(), is_held) &&
                                    !std::all_of(faces.begin(), faces.end(), is_held);
  if (is_at_end_of_support || !std::all_of(faces.begin(), faces.end(), [](const auto& face) {
        return face.traction.has_value();
      }))
    return linear;
  if (is_smooth(faces)) {
    const auto found = stress_on(corners, faces);
    return found ? Recovered<dim>{*found, share_at_surface * (*found - inside)} : linear;
  }
  if (!is_convex(faces)) return linear;
  StressVector<dim> stress = inside;
  for (const FaceThere<dim>& face : faces) {
    if (face.traction->norm() > 0.) return linear;
    stress = without_traction<dim>(stress, face.normal);
  }
  return {stress, share_at_surface * (stress - inside)};
}

template <int dim>
Tensor<1, dim> StressRecovery<dim>::displacement_of(const Cell& cell,
                                                    const unsigned int vertex) const {
  Tensor<1, dim> result;
  for (unsigned int i = 0; i < dim; ++i)
    result[i] = displacement_(cell->vertex_dof_index(vertex, i));
  return result;
}

/// Nodes nearer than a face and a half may carry a part of its force.
template <int dim>
bool StressRecovery<dim>::carries_contact(const Point<dim>& place, const double face_size) const {
  return std::any_of(
      tractions_.in_contact.begin(), tractions_.in_contact.end(),
      [&](const Point<dim>& node) { return node.distance(place) < 1.5 * face_size; });
}

/// @return nothing if the force at the node is not known
template <int dim>
std::optional<Tensor<1, dim>> StressRecovery<dim>::held_traction(const Corner& corner) const {
  Tensor<1, dim> traction;
  for (unsigned int i = 0; i < dim; ++i) {
    const auto found =
        tractions_.at_held.find(cells_[corner.cell]->vertex_dof_index(corner.vertex, i));
    if (found == tractions_.at_held.end()) return std::nullopt;
    traction[i] = found->second;
  }
  return traction;
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

template <int dim>
FaceThere<dim> StressRecovery<dim>::face_there(const Corner& corner,
                                               const unsigned int face) const {
  const Cell& cell = cells_[corner.cell];
  const auto surface = cell->face(face);
  const Point<dim> place = cell->vertex(corner.vertex);
  FaceThere<dim> there;
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
std::vector<FaceThere<dim>> StressRecovery<dim>::faces_at(
    const std::vector<Corner>& corners) const {
  std::vector<FaceThere<dim>> faces;
  for (const Corner& corner : corners) {
    const Cell& cell = cells_[corner.cell];
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
std::optional<StressVector<dim>> StressRecovery<dim>::stress_on(
    const std::vector<Corner>& corners, const std::vector<FaceThere<dim>>& faces) const {
  const Cell& cell = cells_[corners.front().cell];
  const Point<dim> place = cell->vertex(corners.front().vertex);
  const Tensor<1, dim> here = displacement_of(cell, corners.front().vertex);
  Tensor<1, dim> normal;
  Tensor<1, dim> traction;
  std::map<unsigned int, SurfaceNeighbour<dim>> around;
  for (const FaceThere<dim>& face : faces) {
    normal += face.normal;
    traction += *face.traction / static_cast<double>(faces.size());
    const Cell& of_face = cells_[face.cell];
    for (const unsigned int vertex : face.corners)
      around[of_face->vertex_index(vertex)] = {of_face->vertex(vertex) - place,
                                               displacement_of(of_face, vertex) - here};
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
