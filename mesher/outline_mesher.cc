#include "mesher/outline_mesher.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/mesh_quality.h"
#include "mesher/element_blocks.h"
#include "mesher/gmsh_session.h"
#include "mesher/outline_model.h"
#include "mesher/size_field.h"

namespace geneva::mesher {

namespace {

using loads::Loop;
using loads::Outline;
using loads::Point;
using loads::Segment;
using mesh::minimum_scaled_jacobian;
using mesh::minimum_scaled_jacobian_refined;

/// Lengths in outlines of extent 1 are rounded to this grid, so that the mesh does not depend on
/// the last digits, which the unit of length changes.
constexpr double grid = 1. / (1 << 24);

/// A mesh of at least this quality is taken at once.
constexpr double good_quality = 0.2;
/// A mesh below it is not taken at all.
constexpr double minimum_quality = 0.05;

double scaled(double length, double factor) { return std::round(length * factor / grid) * grid; }

Point scaled(Point point, double factor) {
  return {scaled(point.x, factor), scaled(point.y, factor)};
}

std::vector<Outline> scaled(std::vector<Outline> outlines, double factor) {
  for (Outline& outline : outlines)
    for (Loop& loop : outline.loops)
      for (Segment& segment : loop) {
        segment.start = scaled(segment.start, factor);
        segment.end = scaled(segment.end, factor);
        segment.centre = scaled(segment.centre, factor);
      }
  return outlines;
}

MeshSizing scaled(const MeshSizing& sizing, double factor) {
  return {scaled(sizing.general, factor), scaled(sizing.at_contact, factor),
          scaled(sizing.contact, factor), scaled(sizing.contact_distance, factor)};
}

/// One way of meshing: the sizes times a factor; each cell then divided into quadrilaterals or not.
struct Attempt {
  double factor;
  bool divide;
};

void set_options(const Attempt& attempt) {
  set_quadrilateral_options();
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshOnlyEmpty", 1);  // the boundary is there already
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", attempt.divide ? 1 : 0);
}

struct AttemptResult {
  std::optional<MeshData<2>> mesh;
  std::string failure;  ///< why there is none
};

AttemptResult try_meshing(const std::vector<Outline>& outlines, const MeshSizing& sizing,
                          const Attempt& attempt) {
  GmshSession session;
  const double scale = loads::extent(outlines);
  const std::vector<Outline> unit = scaled(outlines, 1. / scale);
  const SizeField size(unit, scaled(sizing, 1. / scale));
  AttemptResult result;
  const auto errors = session.errors_of([&] {
    set_options(attempt);
    gmsh::model::add("outlines");
    const OutlineModel model(outlines, unit, scale, size, attempt.factor);
    gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double) {
      return attempt.factor * size({x, y});
    });
    gmsh::model::mesh::generate(2);
    result.failure = "triangles are left";
    if (has_triangles()) return;
    TaggedMesh<2> read = read_model<2>(model.labels());
    model.place(read);
    result.mesh = std::move(read.mesh);
  });
  if (errors.empty()) return result;
  return {std::nullopt, errors.front()};
}

}  // namespace

MeshData<2> mesh_outlines(const std::vector<Outline>& outlines, const MeshSizing& sizing) {
  std::optional<MeshData<2>> best;
  double best_quality = minimum_quality;
  std::string failure = "there are none";
  // sizes that fit badly into a narrow place give a bad cell there: a little finer or coarser helps
  for (const Attempt attempt :
       {Attempt{1., false}, Attempt{0.9, false}, Attempt{1.1, false}, Attempt{0.8, false},
        Attempt{1.2, false}, Attempt{0.7, false}, Attempt{0.6, false}, Attempt{0.5, false},
        Attempt{2., true}, Attempt{1.5, true}}) {
    AttemptResult result = try_meshing(outlines, sizing, attempt);
    if (!result.mesh) {
      failure = result.failure;
      continue;
    }
    const double quality = std::min(minimum_scaled_jacobian(*result.mesh),
                                    minimum_scaled_jacobian_refined(*result.mesh));
    if (quality < best_quality) {
      failure = fmt::format("the worst cell has a scaled Jacobian of {:.2g}", quality);
      continue;
    }
    best_quality = quality;
    best = std::move(result.mesh);
    if (quality >= good_quality) break;
  }
  if (!best)
    throw std::runtime_error(
        fmt::format("Gmsh found no mesh of good quadrilaterals for the outlines ({}): choose "
                    "another cell size, or dimensions without such narrow places",
                    failure));
  return *best;
}

}  // namespace geneva::mesher
