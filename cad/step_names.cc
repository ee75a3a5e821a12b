#include "cad/step_names.h"

#include <fmt/format.h>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "cad/nearest.h"

namespace geneva::cad {

namespace {

/// Share of the model's extent to which places are equal.
constexpr double same_place = 1e-6;
/// Share of it that the nearest may be away from a pick's place.
constexpr double farthest_pick = 0.05;

const char* body_word(const int dimension) { return dimension == 3 ? "solid" : "face"; }
const char* boundary_word(const int dimension) { return dimension == 3 ? "face" : "edge"; }

std::vector<SelectedBody> of_dimension(const std::vector<StepBody>& bodies, const int dimension) {
  std::vector<SelectedBody> result;
  for (const StepBody& body : bodies) {
    const bool is_solid = body.shape.ShapeType() == TopAbs_SOLID;
    if (is_solid != (dimension == 3)) continue;
    SelectedBody selected{body.name, body.shape, {}};
    if (dimension == 3) {
      for (const NamedFace& face : body.faces) selected.boundary.push_back({face.face, face.name});
    } else {
      TopTools_IndexedMapOfShape edges;
      TopExp::MapShapes(body.shape, TopAbs_EDGE, edges);
      for (int i = 1; i <= edges.Extent(); ++i) selected.boundary.push_back({edges(i), ""});
    }
    result.push_back(std::move(selected));
  }
  if (!result.empty()) return result;
  throw base::InputError(
      dimension == 3
          ? "the file has no solid: export the parts as solids; for its plane faces 'set Dimension "
            "= "
            "2'"
          : "the file has no plane face outside of solids: export the section as faces; for its "
            "solids 'set Dimension = 3'");
}

/// Names of products with numbers where they are not alone.
void number(std::vector<SelectedBody>& bodies, const int dimension) {
  std::map<std::string, int> count;
  for (SelectedBody& body : bodies) {
    if (body.name.empty()) body.name = body_word(dimension);
    ++count[body.name];
  }
  std::map<std::string, int> seen;
  for (SelectedBody& body : bodies) {
    const int place = ++seen[body.name];
    if (count[body.name] > 1) body.name += fmt::format(" {}", place);
  }
}

std::vector<TopoDS_Shape> shapes_of(const std::vector<SelectedBody>& bodies) {
  std::vector<TopoDS_Shape> shapes;
  for (const SelectedBody& body : bodies) shapes.push_back(body.shape);
  return shapes;
}

/// Index of the one shape that a place picks.
/// @param what "face"
std::size_t picked(const std::vector<TopoDS_Shape>& shapes, const PlacedName& pick,
                   const double extent, const char* const what) {
  const auto [found, distance] = nearest(shapes, pick.place, same_place * extent);
  const auto& [x, y, z] = pick.place;
  const std::string place = fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", x, y, z);
  if (distance > farthest_pick * extent)
    throw base::InputError(fmt::format(
        "no {0} is near to {1}, where '{2}' is to be: the nearest is {3:.4g} mm away; 'geneva "
        "surfaces' lists the {0}s with their places",
        what, place, pick.name, distance));
  if (found.size() > 1)
    throw base::InputError(fmt::format(
        "{} {}s are equally near to {}, where '{}' is to be: move the place away from where they "
        "meet",
        found.size(), what, place, pick.name));
  return found.front();
}

void name_bodies(std::vector<SelectedBody>& bodies, const int dimension,
                 const std::vector<PlacedName>& picks) {
  const std::vector<TopoDS_Shape> shapes = shapes_of(bodies);
  const double size = extent(shapes);
  for (const PlacedName& pick : picks)
    if (pick.is_body) bodies[picked(shapes, pick, size, body_word(dimension))].name = pick.name;
}

std::vector<SelectedBody> those(const std::vector<SelectedBody>& bodies,
                                const std::vector<std::string>& wanted) {
  if (wanted.empty()) return bodies;
  std::vector<SelectedBody> result;
  for (const std::string& name : wanted) {
    const auto found = std::find_if(bodies.begin(), bodies.end(),
                                    [&](const SelectedBody& body) { return body.name == name; });
    if (found == bodies.end()) {
      std::vector<std::string> names;
      for (const SelectedBody& body : bodies) names.push_back("'" + body.name + "'");
      throw base::InputError(
          fmt::format("there is no body '{}': the file has {}; name one of them in 'Bodies', or "
                      "'set Solid {} = nearest X, Y, Z' in the case",
                      name, fmt::join(names, ", "), name));
    }
    result.push_back(*found);
  }
  return result;
}

/// Puts the name of the body before names that two bodies have.
void tell_apart(std::vector<SelectedBody>& bodies) {
  std::map<std::string, std::set<std::string>> bodies_of;
  for (const SelectedBody& body : bodies)
    for (const NamedBoundary& part : body.boundary) bodies_of[part.surface].insert(body.name);
  for (SelectedBody& body : bodies)
    for (NamedBoundary& part : body.boundary)
      if (!part.surface.empty() && bodies_of[part.surface].size() > 1)
        part.surface = body.name + " " + part.surface;
}

void number_nameless(SelectedBody& body, const int dimension) {
  for (std::size_t i = 0; i < body.boundary.size(); ++i)
    if (body.boundary[i].surface.empty())
      body.boundary[i].surface =
          fmt::format("{} {} {}", body.name, boundary_word(dimension), i + 1);
}

void name_boundary(std::vector<SelectedBody>& bodies, const int dimension,
                   const std::vector<PlacedName>& picks) {
  std::vector<TopoDS_Shape> shapes;
  std::vector<NamedBoundary*> parts;
  for (SelectedBody& body : bodies)
    for (NamedBoundary& part : body.boundary) {
      shapes.push_back(part.shape);
      parts.push_back(&part);
    }
  const double size = extent(shapes);
  for (const PlacedName& pick : picks)
    if (!pick.is_body)
      parts[picked(shapes, pick, size, boundary_word(dimension))]->surface = pick.name;
}

}  // namespace

std::vector<SelectedBody> select(const std::vector<StepBody>& bodies, const int dimension,
                                 const std::vector<std::string>& wanted,
                                 const std::vector<PlacedName>& picks) {
  std::vector<SelectedBody> all = of_dimension(bodies, dimension);
  number(all, dimension);
  name_bodies(all, dimension, picks);
  std::vector<SelectedBody> result = those(all, wanted);
  tell_apart(result);
  for (SelectedBody& body : result) number_nameless(body, dimension);
  name_boundary(result, dimension, picks);
  return result;
}

}  // namespace geneva::cad
