#include "cad/part_shape.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <ShapeCustom.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <stdexcept>

#include "loads/pi.h"

namespace geneva::cad {

namespace {

using loads::Loop;
using loads::Point;
using loads::Segment;

gp_Pnt point_at(const Point& point, const double z) {
  return {point.x / kernel_unit, point.y / kernel_unit, z / kernel_unit};
}

/// Vertices are shared along the loop, so that it is closed whatever the rounding of its arcs.
TopoDS_Wire wire_of(const Loop& loop, const double z) {
  std::vector<TopoDS_Vertex> vertices;
  for (const Segment& segment : loop)
    vertices.push_back(BRepBuilderAPI_MakeVertex(point_at(segment.start, z)));
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Segment& segment = loop[i];
    const TopoDS_Vertex& start = vertices[i];
    const TopoDS_Vertex& end = vertices[(i + 1) % loop.size()];
    if (!segment.is_arc) {
      wire.Add(BRepBuilderAPI_MakeEdge(start, end));
      continue;
    }
    const gp_Dir up(0., 0., segment.clockwise ? -1. : 1.);
    const double radius =
        std::hypot(segment.start.x - segment.centre.x, segment.start.y - segment.centre.y);
    wire.Add(BRepBuilderAPI_MakeEdge(
        gp_Circ(gp_Ax2(point_at(segment.centre, z), up), radius / kernel_unit), start, end));
  }
  return wire.Wire();
}

TopoDS_Shape solid_of(const loads::Extrusion& extrusion) {
  const auto& loops = extrusion.outline.loops;
  BRepBuilderAPI_MakeFace face(
      gp_Pln(gp_Pnt(0., 0., extrusion.bottom / kernel_unit), gp_Dir(0., 0., 1.)),
      wire_of(loops.front(), extrusion.bottom));
  for (auto hole = loops.begin() + 1; hole != loops.end(); ++hole)
    face.Add(wire_of(*hole, extrusion.bottom));
  return BRepPrimAPI_MakePrism(face.Face(),
                               gp_Vec(0., 0., (extrusion.top - extrusion.bottom) / kernel_unit));
}

/// Distance of a point from the line or circle that a segment is part of.
double distance(const Segment& segment, const Point& point) {
  if (segment.is_arc)
    return std::abs(
        std::hypot(point.x - segment.centre.x, point.y - segment.centre.y) -
        std::hypot(segment.start.x - segment.centre.x, segment.start.y - segment.centre.y));
  const Point along{segment.end.x - segment.start.x, segment.end.y - segment.start.y};
  return std::abs(along.x * (point.y - segment.start.y) - along.y * (point.x - segment.start.x)) /
         std::hypot(along.x, along.y);
}

/// Whether a point of the line or circle lies between the segment's ends.
/// @param rounding [m], > 0
bool is_within(const Segment& segment, const Point& point, const double rounding) {
  if (!segment.is_arc) {
    const Point along{segment.end.x - segment.start.x, segment.end.y - segment.start.y};
    const double length = std::hypot(along.x, along.y);
    const double place =
        ((point.x - segment.start.x) * along.x + (point.y - segment.start.y) * along.y) / length;
    return place > -rounding && place < length + rounding;
  }
  const auto turn_to = [&](const Point& to) {
    const Point from{segment.start.x - segment.centre.x, segment.start.y - segment.centre.y};
    const Point arm{to.x - segment.centre.x, to.y - segment.centre.y};
    const double angle =
        std::atan2(from.x * arm.y - from.y * arm.x, from.x * arm.x + from.y * arm.y);
    const double turn = segment.clockwise ? -angle : angle;
    return turn < 0. ? turn + 2. * loads::pi : turn;
  };
  const double radius =
      std::hypot(segment.start.x - segment.centre.x, segment.start.y - segment.centre.y);
  return turn_to(point) < turn_to(segment.end) + rounding / radius;
}

/// Name of the surface of a face that stands upright.
std::string name_of(const Point& point, const double z, const loads::SolidPart& part,
                    const double rounding) {
  for (const auto& [outline, bottom, top] : part.extrusions) {
    if (z < bottom || z > top) continue;
    for (const Loop& loop : outline.loops)
      for (const Segment& segment : loop)
        if (distance(segment, point) < rounding && is_within(segment, point, rounding))
          return segment.surface;
  }
  return "";
}

/// Places that are equal to this are one, well above rounding [m].
double rounding_of(const loads::SolidPart& part) {
  constexpr double share = 1e-6;
  return share * loads::extent({part.extrusions.front().outline});
}

/// A flat face across the axis is named by its end of the part.
std::string name_of(const TopoDS_Face& face, const loads::SolidPart& part) {
  const double rounding = rounding_of(part);
  const BRepAdaptor_Surface surface(face);
  double u_min = 0.;
  double u_max = 0.;
  double v_min = 0.;
  double v_max = 0.;
  BRepTools::UVBounds(face, u_min, u_max, v_min, v_max);
  const gp_Pnt middle = surface.Value((u_min + u_max) / 2., (v_min + v_max) / 2.);
  if (surface.GetType() == GeomAbs_Plane &&
      std::abs(surface.Plane().Axis().Direction().Z()) > 0.5) {
    double bottom = part.extrusions.front().bottom;
    double top = part.extrusions.front().top;
    for (const loads::Extrusion& extrusion : part.extrusions) {
      bottom = std::min(bottom, extrusion.bottom);
      top = std::max(top, extrusion.top);
    }
    const double z = kernel_unit * middle.Z();
    if (std::abs(z - bottom) < rounding) return "bottom";
    return std::abs(z - top) < rounding ? "top" : "shoulder";
  }
  return name_of({kernel_unit * middle.X(), kernel_unit * middle.Y()}, kernel_unit * middle.Z(),
                 part, rounding);
}

}  // namespace

PartShape shape_of(const loads::SolidPart& part) {
  TopoDS_Shape shape = solid_of(part.extrusions.front());
  for (auto next = part.extrusions.begin() + 1; next != part.extrusions.end(); ++next)
    shape = BRepAlgoAPI_Fuse(shape, solid_of(*next));
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  // The writer replaces faces on left-handed planes, and would not know them by what they were.
  TopExp_Explorer solids(ShapeCustom::DirectFaces(unify.Shape()), TopAbs_SOLID);
  if (!solids.More()) throw std::logic_error("part '" + part.name + "' is no solid");
  PartShape result{solids.Current(), {}};
  solids.Next();
  if (solids.More() || !BRepCheck_Analyzer(result.solid).IsValid())
    throw std::logic_error("part '" + part.name + "' is not one valid solid");
  for (TopExp_Explorer faces(result.solid, TopAbs_FACE); faces.More(); faces.Next())
    result.faces.push_back({faces.Current(), name_of(TopoDS::Face(faces.Current()), part)});
  return result;
}

}  // namespace geneva::cad
