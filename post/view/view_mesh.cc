#include "post/view/view_mesh.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "fem/discretisation/gather.h"
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

ViewPoint between(const ViewPoint& a, const ViewPoint& b, const double fraction) {
  ViewPoint result;
  const auto mix = [&](const auto& from, const auto& to, auto& into) {
    for (std::size_t i = 0; i < into.size(); ++i) into[i] = from[i] + fraction * (to[i] - from[i]);
  };
  mix(a.place, b.place, result.place);
  mix(a.displacement, b.displacement, result.displacement);
  mix(a.fields, b.fields, result.fields);
  result.body = a.body;
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

/// Lines between boundary faces that meet at an angle.
class SharpEdges {
 public:
  /// A line of a face with its outward unit normal; where it is the second face of the line, tells
  /// whether the two meet at an angle.
  bool add(const unsigned int line, const Tensor<1, 3>& normal) {
    constexpr double cosine_of_sharp = 0.9;  // 26 degrees
    const auto [first, is_new] = normals_.emplace(line, normal);
    return !is_new && first->second * normal < cosine_of_sharp;
  }

 private:
  std::map<unsigned int, Tensor<1, 3>> normals_;  // of the first face
};

/// Adds points by their vertices.
template <int dim>
class SkinBuilder {
 public:
  using Cell = typename CornerValues<dim>::Cell;

  SkinBuilder(const fem::Solution<dim>& solution, const Results<dim>& results)
      : values_(solution, results) {}

  void add(const Cell& cell) {
    if constexpr (dim == 2)
      for (const unsigned int corner : two_triangles)
        mesh_.triangles.push_back(point(cell, corner));
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary()) add_face(cell, face);
  }
  [[nodiscard]] const ViewMesh& mesh() const { return mesh_; }

 private:
  using Geometry = dealii::GeometryInfo<dim>;

  unsigned int point(const Cell& cell, const unsigned int corner) {
    const auto next = static_cast<unsigned int>(points_.size());
    const auto [point, is_new] = points_.emplace(cell->vertex_index(corner), next);
    if (is_new) append(values_.at(cell, corner), mesh_);
    return point->second;
  }

  void add_face(const Cell& cell, const unsigned int face) {
    const auto corner_point = [&](const unsigned int corner) {
      return point(cell, Geometry::face_to_cell_vertices(face, corner));
    };
    if constexpr (dim == 2) {
      for (const unsigned int corner : {0U, 1U}) mesh_.outlines.push_back(corner_point(corner));
    } else {
      for (const unsigned int corner : two_triangles)
        mesh_.triangles.push_back(corner_point(corner));
      const auto& quad = cell->face(face);
      Tensor<1, 3> normal =
          dealii::cross_product_3d(Tensor<1, 3>(quad->vertex(3) - quad->vertex(0)),
                                   Tensor<1, 3>(quad->vertex(2) - quad->vertex(1)));
      normal *= ((quad->center() - cell->center()) * normal > 0. ? 1. : -1.) / normal.norm();
      for (unsigned int line = 0; line < 4; ++line)
        if (edges_.add(quad->line_index(line), normal))
          for (const unsigned int end : {0U, 1U})
            mesh_.outlines.push_back(
                corner_point(dealii::GeometryInfo<2>::face_to_cell_vertices(line, end)));
    }
  }

  CornerValues<dim> values_;
  ViewMesh mesh_;
  std::map<unsigned int, unsigned int> points_;  // by vertex
  SharpEdges edges_;
};

/// Visualisation data of this rank's cells.
template <int dim>
ViewMesh own_skin(const fem::Solution<dim>& solution, const Results<dim>& results) {
  SkinBuilder<dim> builder(solution, results);
  for (const auto& cell : solution.dof_handler->active_cell_iterators())
    if (cell->is_locally_owned()) builder.add(cell);
  return builder.mesh();
}

/// This rank's cells cut by a plane.
ViewMesh own_cut(const fem::Solution<3>& solution, const Results<3>& results,
                 const CutPlane& plane) {
  const CornerValues<3> values(solution, results);
  ViewMesh mesh;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> points;  // by edge
  for (const auto& cell : solution.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    std::array<double, 8> distances{};
    for (unsigned int corner = 0; corner < 8; ++corner)
      distances[corner] =
          (solution.scales.length * cell->vertex(corner) - plane.point) * plane.normal;
    for (const auto& triangle : cut_hexahedron(distances))
      for (const EdgePoint& edge : triangle) {
        const std::pair<unsigned int, unsigned int> key =
            std::minmax({cell->vertex_index(edge.first), cell->vertex_index(edge.second)});
        const auto next = static_cast<unsigned int>(points.size());
        const auto [point, is_new] = points.emplace(key, next);
        if (is_new)
          append(between(values.at(cell, edge.first), values.at(cell, edge.second), edge.fraction),
                 mesh);
        mesh.triangles.push_back(point->second);
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
