#include "cad/nearest.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <cmath>

namespace geneva::cad {

Nearest nearest(const std::vector<TopoDS_Shape>& shapes, const std::array<double, 3>& place,
                const double rounding) {
  const TopoDS_Shape point =
      BRepBuilderAPI_MakeVertex(gp_Pnt(place[0], place[1], place[2])).Vertex();
  std::vector<double> distances;
  for (const TopoDS_Shape& shape : shapes)
    distances.push_back(BRepExtrema_DistShapeShape(point, shape).Value());
  Nearest result{{}, *std::min_element(distances.begin(), distances.end())};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (distances[i] < result.distance + rounding) result.shapes.push_back(i);
  return result;
}

double extent(const std::vector<TopoDS_Shape>& shapes) {
  Bnd_Box box;
  for (const TopoDS_Shape& shape : shapes) BRepBndLib::Add(shape, box);
  return std::sqrt(box.SquareExtent());
}

Measure measure(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  if (shape.ShapeType() == TopAbs_SOLID)
    BRepGProp::VolumeProperties(shape, properties);
  else if (shape.ShapeType() == TopAbs_FACE)
    BRepGProp::SurfaceProperties(shape, properties);
  else
    BRepGProp::LinearProperties(shape, properties);
  const gp_Pnt middle = properties.CentreOfMass();
  return {properties.Mass(), {middle.X(), middle.Y(), middle.Z()}};
}

}  // namespace geneva::cad
