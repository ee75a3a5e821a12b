#include "mesher/outline_model.h"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace geneva::mesher {

namespace {

using loads::Loop;
using loads::Outline;
using loads::Point;
using loads::Segment;

constexpr int minimum_layers = 2;     // of a ring
constexpr int most_cells_along = 22;  // of a quadrilateral: refinement does the rest

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Outer boundary and one hole, both of the same number of arcs.
bool is_ring(const Outline& outline) {
  if (outline.loops.size() != 2 || outline.loops[0].size() != outline.loops[1].size()) return false;
  const auto all_arcs = [](const Loop& loop) {
    return std::all_of(loop.begin(), loop.end(), [](const Segment& s) { return s.is_arc; });
  };
  return outline.loops[0].size() > 1 && all_arcs(outline.loops[0]) && all_arcs(outline.loops[1]);
}

/// One boundary of four lines.
bool is_quadrilateral(const Outline& outline) {
  return outline.loops.size() == 1 && outline.loops[0].size() == 4 &&
         std::none_of(outline.loops[0].begin(), outline.loops[0].end(),
                      [](const Segment& s) { return s.is_arc; });
}

/// Divides a segment into cells that follow the sizes counted by cells_along.
std::vector<double> divided(const std::vector<double>& cells_along, int cells) {
  std::vector<double> places;
  const double intervals = static_cast<double>(cells_along.size() - 1);
  std::size_t i = 0;
  for (int k = 1; k < cells; ++k) {
    const double wanted = cells_along.back() * k / cells;
    while (cells_along[i + 1] < wanted) ++i;
    const double part = (wanted - cells_along[i]) / (cells_along[i + 1] - cells_along[i]);
    places.push_back((static_cast<double>(i) + part) / intervals);
  }
  return places;
}

std::vector<double> evenly_divided(int cells) { return divided({0., 1.}, cells); }

int add_point(Point point) { return gmsh::model::geo::addPoint(point.x, point.y, 0.); }

/// Index of the hole's vertex next to the outer loop's first one.
std::size_t opposite(const Loop& outer, const Loop& hole) {
  const Point first = outer.front().start;
  const auto nearest =
      std::min_element(hole.begin(), hole.end(), [&](const Segment& a, const Segment& b) {
        return distance(a.start, first) < distance(b.start, first);
      });
  return static_cast<std::size_t>(nearest - hole.begin());
}

/// Nodes inside of an entity and their places.
std::vector<std::pair<std::size_t, Point>> nodes_of(int dimension, int tag) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, dimension, tag);
  std::vector<std::pair<std::size_t, Point>> nodes;
  for (std::size_t i = 0; i < tags.size(); ++i)
    nodes.emplace_back(tags[i], Point{coordinates[3 * i], coordinates[3 * i + 1]});
  return nodes;
}

/// The point of a segment nearest to a place that is next to it.
Point onto(const Segment& segment, Point place) {
  if (!segment.is_arc)
    return point_of(segment, distance(place, segment.start) / distance(segment.start, segment.end));
  const Point& centre = segment.centre;
  const double stretch = distance(segment.start, centre) / distance(place, centre);
  return {centre.x + stretch * (place.x - centre.x), centre.y + stretch * (place.y - centre.y)};
}

}  // namespace

OutlineModel::OutlineModel(const std::vector<Outline>& exact, const std::vector<Outline>& unit,
                           double scale, const SizeField& size, double factor)
    : scale_(scale), size_(size), factor_(factor) {
  for (std::size_t i = 0; i < unit.size(); ++i) add_body(unit[i], exact[i]);
  gmsh::model::geo::synchronize();
  for (const auto& [tag, place] : points_) add_node(tag);
  for (const auto& [tag, curve] : curves_) add_lines(tag, curve);
  for (const int surface : patches_) gmsh::model::mesh::setTransfiniteSurface(surface);
}

void OutlineModel::add_body(const Outline& unit, const Outline& exact) {
  std::vector<LoopTags> loops;
  for (std::size_t i = 0; i < unit.loops.size(); ++i)
    loops.push_back(add_loop(unit.loops[i], exact.loops[i]));
  labels_.bodies.push_back({unit.name, {}});
  if (is_ring(unit)) return add_ring(unit, loops);
  if (is_quadrilateral(unit)) return add_quadrilateral(unit.loops[0], loops[0]);
  divide(loops);
  std::vector<int> loop_tags;
  loop_tags.reserve(loops.size());
  for (const LoopTags& loop : loops)
    loop_tags.push_back(gmsh::model::geo::addCurveLoop(loop.curves));
  labels_.bodies.back().entities.push_back(gmsh::model::geo::addPlaneSurface(loop_tags));
}

OutlineModel::LoopTags OutlineModel::add_loop(const Loop& unit, const Loop& exact) {
  LoopTags tags;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    tags.points.push_back(add_point(unit[i].start));
    points_[tags.points.back()] = exact[i].start;
  }
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::array<int, 2> ends{tags.points[i], tags.points[(i + 1) % unit.size()]};
    const int tag =
        unit[i].is_arc ? gmsh::model::geo::addCircleArc(ends[0], add_point(unit[i].centre), ends[1])
                       : gmsh::model::geo::addLine(ends[0], ends[1]);
    tags.curves.push_back(tag);
    curves_[tag] = {unit[i], &exact[i], ends, {}};
    add_label(tag, exact[i]);
  }
  return tags;
}

void OutlineModel::add_label(int curve, const Segment& exact) {
  const Circle circle{{exact.centre.x, exact.centre.y}, distance(exact.start, exact.centre)};
  labels_.boundary[curve] = {exact.surface,
                             exact.is_arc ? circle_index(labels_.circles, circle) : -1};
  labels_.surfaces.push_back(exact.surface);
}

/// Number of cells, at least one.
int OutlineModel::count(double cells) const {
  return std::max(1, static_cast<int>(std::lround(cells / factor_)));
}

/// Divides the boundary of a body so that its number of cells is even.
void OutlineModel::divide(const std::vector<LoopTags>& loops) {
  int total = 0;
  std::pair<double, int> coarsest{0., 0};  // cells wanted per cell given, and the curve
  std::map<int, int> cells;
  for (const LoopTags& loop : loops)
    for (const int tag : loop.curves) {
      const double wanted = size_.cells_along(curves_[tag].unit).back();
      cells[tag] = std::max(count(wanted), minimum_cells(curves_[tag].unit));
      total += cells[tag];
      coarsest = std::max(coarsest, {wanted / cells[tag], tag});
    }
  if (total % 2 != 0) ++cells[coarsest.second];
  for (const auto& [tag, number] : cells)
    curves_[tag].places = divided(size_.cells_along(curves_[tag].unit), number);
}

/// A regular mesh of even cells: where three or more cells meet at a vertex of the boundary, linear
/// elements have a defect of the contact pressure that refinement does not remove.
void OutlineModel::add_quadrilateral(const Loop& unit, const LoopTags& loop) {
  const auto cells_on = [&](const std::size_t side) {
    return count(
        std::max(size_.cells_along(unit[side]).back(), size_.cells_along(unit[side + 2]).back()));
  };
  const int along = std::min(cells_on(0), most_cells_along);
  const double size = length_of(unit[0]) / along;
  const int across = std::max(1, static_cast<int>(std::lround(length_of(unit[1]) / size)));
  for (std::size_t side = 0; side < 4; ++side)
    curves_[loop.curves[side]].places = evenly_divided(side % 2 == 0 ? along : across);
  const int tag = gmsh::model::geo::addCurveLoop(loop.curves);
  patches_.push_back(gmsh::model::geo::addPlaneSurface({tag}));
  labels_.bodies.back().entities.push_back(patches_.back());
}

/// Four-sided patches between the arcs of the outer loop and those of the hole, which runs the
/// other way round.
void OutlineModel::add_ring(const Outline& unit, const std::vector<LoopTags>& loops) {
  const Loop& outer = unit.loops[0];
  const Loop& hole = unit.loops[1];
  const std::size_t arcs = outer.size();
  const std::size_t first = opposite(outer, hole);
  const auto inner = [&](std::size_t i) { return (first + arcs - i) % arcs; };
  const double size = size_(outer[0].start);
  const double thickness = distance(outer[0].start, hole[first].start);
  const int layers = std::max(minimum_layers, count(thickness / size));
  std::vector<int> radial;
  for (std::size_t i = 0; i < arcs; ++i) {
    const std::array<int, 2> ends{loops[0].points[i], loops[1].points[inner(i)]};
    radial.push_back(gmsh::model::geo::addLine(ends[0], ends[1]));
    const Segment line{outer[i].start, hole[inner(i)].start, false, {0., 0.}, false, ""};
    curves_[radial.back()] = {line, nullptr, ends, evenly_divided(layers)};
  }
  for (std::size_t i = 0; i < arcs; ++i) {
    const std::size_t next = (i + 1) % arcs;
    const int outer_arc = loops[0].curves[i];
    const int hole_arc = loops[1].curves[inner(next)];
    const int cells = std::max(count(length_of(outer[i]) / size), minimum_cells(outer[i]));
    for (const int arc : {outer_arc, hole_arc}) curves_[arc].places = evenly_divided(cells);
    const int patch =
        gmsh::model::geo::addCurveLoop({outer_arc, radial[next], hole_arc, -radial[i]});
    patches_.push_back(gmsh::model::geo::addPlaneSurface({patch}));
    labels_.bodies.back().entities.push_back(patches_.back());
  }
}

void OutlineModel::add_node(int point) {
  std::vector<double> place;
  gmsh::model::getValue(0, point, {}, place);
  node_of_point_[point] = ++last_node_;
  gmsh::model::mesh::addNodes(0, point, {last_node_}, place);
}

void OutlineModel::add_lines(int tag, const Curve& curve) {
  std::vector<std::size_t> inside;
  std::vector<double> coordinates;
  for (const double t : curve.places) {
    const Point place = point_of(curve.unit, t);
    inside.push_back(++last_node_);
    coordinates.insert(coordinates.end(), {place.x, place.y, 0.});
  }
  if (!inside.empty()) gmsh::model::mesh::addNodes(1, tag, inside, coordinates, curve.places);
  std::vector<std::size_t> chain{node_of_point_.at(curve.ends[0])};
  chain.insert(chain.end(), inside.begin(), inside.end());
  chain.push_back(node_of_point_.at(curve.ends[1]));
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    lines.insert(lines.end(), {chain[i], chain[i + 1]});
  gmsh::model::mesh::addElementsByType(tag, line_type, {}, lines);
}

/// Where the nodes of the boundary stand, by Gmsh's tag [m]. Gmsh may have added nodes to the
/// curves, and numbers all of them anew when it meshes.
std::map<std::size_t, Point> OutlineModel::boundary_places() const {
  std::map<std::size_t, Point> places;
  for (const auto& [tag, curve] : curves_)
    if (curve.exact != nullptr)
      for (const auto& [node, place] : nodes_of(1, tag))
        places[node] = onto(*curve.exact, {scale_ * place.x, scale_ * place.y});
  for (const auto& [tag, exact] : points_)
    for (const auto& [node, place] : nodes_of(0, tag)) places[node] = exact;
  return places;
}

void OutlineModel::place(TaggedMesh<2>& read) const {
  const std::map<std::size_t, Point> on_boundary = boundary_places();
  for (std::size_t i = 0; i < read.tags.size(); ++i) {
    auto& [x, y] = read.mesh.vertices[i];
    const auto found = on_boundary.find(read.tags[i]);
    const Point place = found == on_boundary.end() ? Point{x * scale_, y * scale_} : found->second;
    x = place.x;
    y = place.y;
  }
}

}  // namespace geneva::mesher
