#include "post/view/view_mesh.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "fem/discretisation/gather.h"
#include "fem/discretisation/round_cell.h"
#include "post/view/hexahedron_cut.h"

namespace geneva::post {

using dealii::Point;
using dealii::Tensor;

namespace {

constexpr std::size_t n_fields = view_fields.size();

/// Everything that is shown at a place.
struct ViewPoint {
  std::array<double, 3> place{};
  std::array<double, 3> displacement{};
  std::array<double, n_fields> fields{};
  unsigned int body = 0;
};

/// Adds a share of another point's place and values.
void add(ViewPoint& sum, const double share, const ViewPoint& other) {
  const auto add_to = [share](auto& into, const auto& from) {
    for (std::size_t i = 0; i < into.size(); ++i) into[i] += share * from[i];
  };
  add_to(sum.place, other.place);
  add_to(sum.displacement, other.displacement);
  add_to(sum.fields, other.fields);
  sum.body = other.body;
}

ViewPoint between(const ViewPoint& a, const ViewPoint& b, const double fraction) {
  ViewPoint result;
  add(result, 1. - fraction, a);
  add(result, fraction, b);
  return result;
}

void append(const ViewPoint& point, ViewMesh& mesh) {
  mesh.points.insert(mesh.points.end(), point.place.begin(), point.place.end());
  for (const double u : point.displacement) mesh.displacements.push_back(static_cast<float>(u));
  for (std::size_t i = 0; i < n_fields; ++i)
    mesh.fields[i].push_back(static_cast<float>(point.fields[i]));
  mesh.bodies.push_back(point.body);
}

/// Frobenius norm of the difference from McEwen's stress where he has one.
double mcewen_difference(const fem::Solution<2>& solution, const Results<2>& results,
                         const Stress<2>& stress, const unsigned int body, const Point<2>& place) {
  const double poissons_ratio = solution.problem.bodies[body].material.poissons_ratio;
  for (const ContactAnalysis<2>& contact : results.contacts)
    if (contact.hertz)
      if (const auto exact =
              mcewen_stress(*contact.hertz, solution.problem.plane, poissons_ratio, place))
        return (stress.in_plane - exact->in_plane).norm();
  return std::numeric_limits<double>::quiet_NaN();
}
double mcewen_difference(const fem::Solution<3>& solution, const Results<3>& results,
                         const Stress<3>& stress, const unsigned int body, const Point<3>& place) {
  const double poissons_ratio = solution.problem.bodies[body].material.poissons_ratio;
  for (const ContactAnalysis<3>& contact : results.contacts)
    if (contact.hertz)
      if (const auto exact = mcewen_stress(*contact.hertz, contact.frame, poissons_ratio, place))
        return (stress - *exact).norm();
  return std::numeric_limits<double>::quiet_NaN();
}

/// Places and fields of cells' corners.
template <int dim>
class CornerValues {
 public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  CornerValues(const fem::Solution<dim>& solution, const Results<dim>& results)
      : solution_(solution), results_(results) {}

  [[nodiscard]] ViewPoint at(const Cell& cell, const unsigned int corner) const {
    const Cell stress_cell(&*solution_.triangulation, cell->level(), cell->index(),
                           results_.nodal.dof_handler.get());
    const Point<dim> place = solution_.scales.length * cell->vertex(corner);
    ViewPoint point;
    for (unsigned int i = 0; i < dim; ++i) {
      point.place[i] = place[i];
      point.displacement[i] =
          solution_.scales.length * solution_.displacement(cell->vertex_dof_index(corner, i));
    }
    const auto stress = assembled_stress<dim>([&](const unsigned int component) {
      return results_.nodal.values(stress_cell->vertex_dof_index(corner, component));
    });
    const auto principal = principal_stresses(stress);
    point.body = cell->material_id();
    point.fields = {von_mises(principal),
                    max_shear(principal),
                    principal[0],
                    principal[1],
                    principal[2],
                    mcewen_difference(solution_, results_, stress, cell->material_id(), place)};
    return point;
  }

 private:
  const fem::Solution<dim>& solution_;
  const Results<dim>& results_;
};

/// A cell that is shown in parts, the rounder its surface the more of them: the points of the
/// parts, values between those of the cell's corners.
template <int dim>
class ShownCell {
 public:
  using Cell = typename CornerValues<dim>::Cell;

  ShownCell(const Cell& cell, const CornerValues<dim>& values, const double length)
      : round_(cell), length_(length) {
    for (const unsigned int corner : cell->vertex_indices())
      corners_.push_back(values.at(cell, corner));
  }

  [[nodiscard]] const fem::RoundCell<dim>& round() const { return round_; }

  [[nodiscard]] ViewPoint at(const fem::PartCorner& corner) const {
    using Geometry = dealii::GeometryInfo<dim>;
    const Point<dim> reference = round_.reference(corner);
    ViewPoint point;
    for (unsigned int i = 0; i < corners_.size(); ++i)
      add(point, Geometry::d_linear_shape_function(reference, i), corners_[i]);
    const Point<dim> place = length_ * round_.place(reference);
    for (unsigned int i = 0; i < dim; ++i) point.place[i] = place[i];
    return point;
  }

  /// Whether a part, by its first corner, bounds the cell at a face.
  [[nodiscard]] bool is_at(const unsigned int face, const fem::PartCorner& first) const {
    const unsigned int axis = face / 2;
    return first[axis] == (face % 2 == 0 ? 0 : round_.parts()[axis] - 1);
  }

  /// The corners of parts from one vertex of the cell to the other end of its line.
  [[nodiscard]] std::vector<fem::PartCorner> along(const unsigned int begin,
                                                   const unsigned int end) const {
    fem::PartCorner first = round_.at_vertex(begin);
    std::vector<fem::PartCorner> corners;
    for (unsigned int axis = 0; axis < dim; ++axis)
      if ((begin ^ end) == 1U << axis)
        for (unsigned int i = 0; i <= round_.parts()[axis]; ++i) {
          first[axis] = i;
          corners.push_back(first);
        }
    return corners;
  }

  /// The vertex of the cell at a corner of its parts, if it is there.
  [[nodiscard]] std::optional<unsigned int> vertex(const fem::PartCorner& corner) const {
    for (unsigned int i = 0; i < corners_.size(); ++i)
      if (round_.at_vertex(i) == corner) return i;
    return std::nullopt;
  }

 private:
  fem::RoundCell<dim> round_;
  double length_;
  std::vector<ViewPoint> corners_;
};

/// How many points the ranks before this one have.
unsigned int points_before(const std::size_t own, const MPI_Comm communicator) {
  const std::vector<std::size_t> counts = fem::gathered_one(communicator, own);
  const auto rank =
      static_cast<std::ptrdiff_t>(dealii::Utilities::MPI::this_mpi_process(communicator));
  return static_cast<unsigned int>(
      std::accumulate(counts.begin(), counts.begin() + rank, std::size_t{0}));
}

/// The parts of all ranks one after the other, on rank 0.
ViewMesh gathered(ViewMesh part, const MPI_Comm communicator) {
  const unsigned int first = points_before(part.bodies.size(), communicator);
  for (std::vector<unsigned int>* const points : {&part.triangles, &part.outlines})
    for (unsigned int& point : *points) point += first;
  ViewMesh whole;
  const auto gather = [&](const auto& from, auto& into) {
    into = fem::gathered_on_first(communicator, from);
  };
  gather(part.bodies, whole.bodies);
  gather(part.points, whole.points);
  gather(part.displacements, whole.displacements);
  for (std::size_t i = 0; i < n_fields; ++i) gather(part.fields[i], whole.fields[i]);
  gather(part.triangles, whole.triangles);
  gather(part.outlines, whole.outlines);
  return whole;
}

/// Two triangles of a quadrilateral with corners in lexicographic order.
constexpr std::array<unsigned int, 6> two_triangles{0, 1, 3, 0, 3, 2};

/// Lines between boundary faces of this rank's cells that meet at an angle.
class SharpEdges {
 public:
  explicit SharpEdges(const dealii::DoFHandler<3>& dof_handler) {
    for (const auto& cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const auto& face : cell->face_iterators())
          if (face->at_boundary()) add(face, Tensor<1, 3>(face->center() - cell->center()));
  }

  /// Whether a line is one of them and has not been asked for before.
  bool take(const unsigned int line) { return lines_.erase(line) > 0; }

 private:
  template <typename Face>
  void add(const Face& face, const Tensor<1, 3>& outwards) {
    constexpr double cosine_of_sharp = 0.9;  // 26 degrees
    Tensor<1, 3> normal = dealii::cross_product_3d(Tensor<1, 3>(face->vertex(3) - face->vertex(0)),
                                                   Tensor<1, 3>(face->vertex(2) - face->vertex(1)));
    normal *= (outwards * normal > 0. ? 1. : -1.) / normal.norm();
    for (unsigned int i = 0; i < 4; ++i) {
      const auto [first, is_new] = normals_.emplace(face->line_index(i), normal);
      if (!is_new && first->second * normal < cosine_of_sharp) lines_.insert(first->first);
    }
  }

  std::map<unsigned int, Tensor<1, 3>> normals_;  // of the first face
  std::set<unsigned int> lines_;
};

/// Adds the points of cells and of the parts of round ones. Straight cells share those of their
/// vertices.
template <int dim>
class SkinBuilder {
 public:
  using Cell = typename CornerValues<dim>::Cell;

  SkinBuilder(const fem::Solution<dim>& solution, const Results<dim>& results)
      : values_(solution, results), length_(solution.scales.length) {}

  void add(const Cell& cell) {
    const ShownCell<dim> shown(cell, values_, length_);
    Points of_cell;
    for (const fem::PartCorner& first : shown.round().first_corners()) {
      const auto corner = [&](const unsigned int i) {
        return point(cell, shown, shown.round().corner_of_part(first, i), of_cell);
      };
      if constexpr (dim == 2) add_triangles(corner);
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() && shown.is_at(face, first))
          add_face([&](const unsigned int i) {
            return corner(dealii::GeometryInfo<dim>::face_to_cell_vertices(face, i));
          });
    }
  }

  /// The lines of a cell that are sharp edges.
  void add_edges(const Cell& cell, SharpEdges& edges) {
    if constexpr (dim == 3) {
      const ShownCell<dim> shown(cell, values_, length_);
      Points of_cell;
      for (const unsigned int line : cell->line_indices()) {
        if (!edges.take(cell->line_index(line))) continue;
        const unsigned int begin = dealii::GeometryInfo<3>::line_to_cell_vertices(line, 0);
        const unsigned int end = dealii::GeometryInfo<3>::line_to_cell_vertices(line, 1);
        const std::vector<fem::PartCorner> numbers = shown.along(begin, end);
        for (std::size_t i = 0; i + 1 < numbers.size(); ++i)
          for (const std::size_t k : {i, i + 1})
            mesh_.outlines.push_back(point(cell, shown, numbers[k], of_cell));
      }
    }
  }

  [[nodiscard]] const ViewMesh& mesh() const { return mesh_; }

 private:
  using Points = std::map<fem::PartCorner, unsigned int>;

  unsigned int point(const Cell& cell, const ShownCell<dim>& shown, const fem::PartCorner& number,
                     Points& of_cell) {
    const auto known_or_new = [&](auto& points, const auto& key) {
      const auto [known, is_new] =
          points.emplace(key, static_cast<unsigned int>(mesh_.bodies.size()));
      if (is_new) append(shown.at(number), mesh_);
      return known->second;
    };
    if (shown.round().is_round()) return known_or_new(of_cell, number);
    return known_or_new(of_vertices_, cell->vertex_index(*shown.vertex(number)));
  }

  template <typename Corner>
  void add_triangles(const Corner& corner) {
    for (const unsigned int i : two_triangles) mesh_.triangles.push_back(corner(i));
  }

  template <typename Corner>
  void add_face(const Corner& corner) {
    if constexpr (dim == 2)
      for (const unsigned int i : {0U, 1U}) mesh_.outlines.push_back(corner(i));
    else
      add_triangles(corner);
  }

  CornerValues<dim> values_;
  double length_;
  ViewMesh mesh_;
  std::map<unsigned int, unsigned int> of_vertices_;
};

/// Visualisation data of this rank's cells.
template <int dim>
ViewMesh own_skin(const fem::Solution<dim>& solution, const Results<dim>& results) {
  SkinBuilder<dim> builder(solution, results);
  for (const auto& cell : solution.dof_handler->active_cell_iterators())
    if (cell->is_locally_owned() && (dim == 2 || cell->at_boundary())) builder.add(cell);
  if constexpr (dim == 3) {
    SharpEdges edges(*solution.dof_handler);
    for (const auto& cell : solution.dof_handler->active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary()) builder.add_edges(cell, edges);
  }
  return builder.mesh();
}

/// Adds the triangles in which a plane cuts a hexahedron.
/// @param point_on of an edge's ends and the point
template <typename PointOn>
void add_cut(const std::array<double, 8>& distances, const PointOn& point_on, ViewMesh& mesh) {
  for (const auto& triangle : cut_hexahedron(distances))
    for (const EdgePoint& edge : triangle) mesh.triangles.push_back(point_on(edge));
}

/// This rank's cells cut by a plane; straight ones share points by their edges.
ViewMesh own_cut(const fem::Solution<3>& solution, const Results<3>& results,
                 const CutPlane& plane) {
  const CornerValues<3> values(solution, results);
  const double length = solution.scales.length;
  ViewMesh mesh;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> of_edges;
  const auto distance = [&](const Point<3>& place) { return (place - plane.point) * plane.normal; };
  const auto append_between = [&](const ViewPoint& begin, const ViewPoint& end,
                                  const double fraction) {
    append(between(begin, end, fraction), mesh);
    return static_cast<unsigned int>(mesh.bodies.size() - 1);
  };
  for (const auto& cell : solution.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    std::array<double, 8> distances{};
    if (!cell->at_boundary() || !fem::RoundCell<3>(cell).is_round()) {
      for (unsigned int i = 0; i < 8; ++i) distances[i] = distance(length * cell->vertex(i));
      const auto on_edge = [&](const EdgePoint& edge) {
        const std::pair<unsigned int, unsigned int> key =
            std::minmax({cell->vertex_index(edge.first), cell->vertex_index(edge.second)});
        const auto known = of_edges.find(key);
        if (known != of_edges.end()) return known->second;
        const unsigned int added = append_between(values.at(cell, edge.first),
                                                  values.at(cell, edge.second), edge.fraction);
        of_edges.emplace(key, added);
        return added;
      };
      add_cut(distances, on_edge, mesh);
      continue;
    }
    const ShownCell<3> shown(cell, values, length);
    for (const fem::PartCorner& first : shown.round().first_corners()) {
      std::array<ViewPoint, 8> corners;
      for (unsigned int i = 0; i < 8; ++i) {
        corners[i] = shown.at(shown.round().corner_of_part(first, i));
        distances[i] =
            distance(Point<3>(corners[i].place[0], corners[i].place[1], corners[i].place[2]));
      }
      add_cut(
          distances,
          [&](const EdgePoint& edge) {
            return append_between(corners[edge.first], corners[edge.second], edge.fraction);
          },
          mesh);
    }
  }
  return mesh;
}

}  // namespace

template <int dim>
ViewMesh visible_mesh(const fem::Solution<dim>& solution, const Results<dim>& results) {
  return gathered(own_skin(solution, results), solution.dof_handler->get_communicator());
}

ViewMesh cut_mesh(const fem::Solution<3>& solution, const Results<3>& results,
                  const CutPlane& plane) {
  return gathered(own_cut(solution, results, plane), solution.dof_handler->get_communicator());
}

template ViewMesh visible_mesh(const fem::Solution<2>&, const Results<2>&);
template ViewMesh visible_mesh(const fem::Solution<3>&, const Results<3>&);

}  // namespace geneva::post
