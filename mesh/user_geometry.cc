#include "mesh/user_geometry.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/geometry_guard.h"
#include "mesh/gmsh_session.h"
#include "mesh/model_reader.h"
#include "mesh/msh_file.h"
#include "mesh/private_directory.h"

namespace geneva::mesh {

namespace {

using Place = std::array<double, 2>;
using Errors = std::vector<std::string>;

/// Points of a circle agree with it to this fraction of its radius.
constexpr double circle_tolerance = 1e-8;
/// Fewer points could lie on a circle by chance.
constexpr std::size_t fewest_circle_points = 5;

std::string listed(const Errors& errors) {
  const std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, errors.size()); ++i)
    text += (i == 0 ? "" : "; ") + errors[i];
  if (errors.size() > most) text += fmt::format("; and {} more errors", errors.size() - most);
  return text;
}

/// Gmsh's "'file', line 7: what" with the user's file and line in the place of Gmsh's.
std::string with_source(const std::string& error, const GuardedGeometry& geometry) {
  if (geometry.lines.empty()) return error;
  const std::string before = "', line ";
  const std::size_t at = error.find(before);
  if (error.rfind('\'', 0) != 0 || at == error.npos) return error;
  const std::size_t number = at + before.size();
  const std::size_t end = error.find(':', number);
  if (end == error.npos || end - number > 8) return error;
  int line = 0;
  for (std::size_t i = number; i < end; ++i) {
    if (std::isdigit(static_cast<unsigned char>(error[i])) == 0) return error;
    line = 10 * line + (error[i] - '0');
  }
  const auto index =
      static_cast<std::size_t>(std::clamp(line, 1, static_cast<int>(geometry.lines.size())) - 1);
  const SourceLine& source = geometry.lines[index];
  return fmt::format("{}:{}{}", source.file.string(), source.number, error.substr(end));
}

/// Name of every physical group of a dimension, by tag.
std::map<int, std::string> group_names(int dimension) {
  const std::string kind = dimension == 1 ? "Physical Curve" : "Physical Surface";
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dimension);
  std::map<int, std::string> names;
  std::set<std::string> seen;
  for (const auto& [dim, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    if (name.empty())
      throw std::invalid_argument(fmt::format(
          "{0} {1} has no name: write {0}(\"name\", {1}), supports and loads go by names", kind,
          tag));
    if (!seen.insert(name).second)
      throw std::invalid_argument(fmt::format(
          "the name \"{}\" is used for more than one {}: give each its own, or list all entities "
          "in one group",
          name, kind));
    names[tag] = name;
  }
  return names;
}

/// Name of the entity's physical group; nothing if it is in none.
std::optional<std::string> group_of(int dimension, int entity,
                                    const std::map<int, std::string>& names) {
  std::vector<int> groups;
  gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
  // a negative number is a group that has the entity in its other direction
  const auto name = [&](int group) { return names.at(std::abs(group)); };
  if (groups.size() > 1)
    throw std::invalid_argument(fmt::format(
        "{} {} is in the physical groups \"{}\" and \"{}\": it may be in one only",
        dimension == 1 ? "curve" : "surface", entity, name(groups[0]), name(groups[1])));
  if (groups.empty()) return std::nullopt;
  return name(groups.front());
}

/// The circle through three points; nothing if they lie in a line.
std::optional<Circle> circle_through(const Place& a, const Place& b, const Place& c) {
  const double bx = b[0] - a[0];
  const double by = b[1] - a[1];
  const double cx = c[0] - a[0];
  const double cy = c[1] - a[1];
  const double cross = 2. * (bx * cy - by * cx);
  const double lengths = std::max({std::hypot(bx, by), std::hypot(cx, cy)});
  if (!(std::abs(cross) > circle_tolerance * lengths * lengths)) return std::nullopt;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double x = (cy * b2 - by * c2) / cross;
  const double y = (bx * c2 - cx * b2) / cross;
  return Circle{{a[0] + x, a[1] + y}, std::hypot(x, y)};
}

/// The circle on which all points lie, if there is one; the points need not be in order.
std::optional<Circle> circle_of(const std::vector<Place>& points) {
  if (points.size() < fewest_circle_points) return std::nullopt;
  const auto off = [](const Place& a, const Place& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  };
  // three points far from each other make the result least sensitive to rounding
  const Place& a = points.front();
  const Place& b = *std::max_element(points.begin(), points.end(),
                                     [&](auto& p, auto& q) { return off(p, a) < off(q, a); });
  const Place& c = *std::max_element(points.begin(), points.end(), [&](auto& p, auto& q) {
    return std::min(off(p, a), off(p, b)) < std::min(off(q, a), off(q, b));
  });
  const std::optional<Circle> circle = circle_through(a, b, c);
  if (!circle) return std::nullopt;
  const bool all_on = std::all_of(points.begin(), points.end(), [&](const Place& point) {
    return std::abs(off(point, circle->centre) - circle->radius) <=
           circle_tolerance * circle->radius;
  });
  return all_on ? circle : std::nullopt;
}

/// Points of a curve of a geometry at evenly spaced parameters.
std::vector<Place> points_of_curve(int curve) {
  std::vector<double> low;
  std::vector<double> high;
  gmsh::model::getParametrizationBounds(1, curve, low, high);
  const int intervals = 6;
  std::vector<double> parameters;
  for (int i = 0; i <= intervals; ++i)
    parameters.push_back(low.at(0) + (high.at(0) - low.at(0)) * i / intervals);
  std::vector<double> places;
  gmsh::model::getValue(1, curve, parameters, places);
  std::vector<Place> points;
  for (std::size_t i = 0; i + 2 < places.size(); i += 3)
    points.push_back({places[i], places[i + 1]});
  return points;
}

/// Nodes of a curve of a mesh.
std::vector<Place> nodes_of_curve(int curve) {
  std::vector<std::size_t> tags;
  std::vector<double> places;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, places, parameters, 1, curve, true);
  std::vector<Place> points;
  for (std::size_t i = 0; i < tags.size(); ++i)
    points.push_back({places[3 * i], places[3 * i + 1]});
  return points;
}

std::optional<Circle> circle_of_curve(int curve) {
  std::string type;
  gmsh::model::getType(1, curve, type);
  if (type == "Line") return std::nullopt;
  const bool is_discrete = type.rfind("Discrete", 0) == 0;
  return circle_of(is_discrete ? nodes_of_curve(curve) : points_of_curve(curve));
}

bool has_cells(int surface) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, 2, surface);
  return !types.empty();
}

void label_bodies(ModelLabels& labels) {
  const std::map<int, std::string> names = group_names(2);
  if (names.empty())
    throw std::invalid_argument(
        "there is no physical surface: write Physical Surface(\"name\") = {...}; for each body");
  for (const auto& [tag, name] : names) labels.bodies.push_back({name, {}});
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  for (const auto& [dimension, surface] : surfaces) {
    const std::optional<std::string> name = group_of(2, surface, names);
    if (!name && has_cells(surface))
      throw std::invalid_argument(
          fmt::format("surface {} is meshed but in no physical group: write Physical "
                      "Surface(\"name\") = {{{}, ...}}; or delete it",
                      surface, surface));
    for (ModelLabels::Body& body : labels.bodies)
      if (name && body.name == *name) body.surfaces.push_back(surface);
  }
}

void label_curves(ModelLabels& labels) {
  const std::map<int, std::string> names = group_names(1);
  if (names.empty())
    throw std::invalid_argument(
        "there is no physical curve: write Physical Curve(\"name\") = {...}; for each part of the "
        "boundary that is held, loaded or touches");
  for (const auto& [tag, name] : names) labels.surfaces.push_back(name);
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  for (const auto& [dimension, curve] : curves) {
    const std::optional<Circle> circle = circle_of_curve(curve);
    labels.curves[curve] = {group_of(1, curve, names).value_or(""),
                            circle ? circle_index(labels.circles, *circle) : -1};
  }
}

void check_cells(const OtherCells& cells, bool is_mesh_file) {
  if (cells.of_higher_order > 0)
    throw std::invalid_argument(
        fmt::format("{} cells are of order 2 or higher: linear quadrilaterals only; set "
                    "Mesh.ElementOrder = 1 (curved boundaries are followed while refining)",
                    cells.of_higher_order));
  if (cells.triangles + cells.others > 0)
    throw std::invalid_argument(
        fmt::format("{} cells are triangles or polygons: linear quadrilaterals only; {}",
                    cells.triangles + cells.others,
                    is_mesh_file ? "write Recombine Surface {...}; in the .geo and mesh it again, "
                                   "or give the .geo file itself"
                                 : "let the program mesh (no 'Mesh 2;'), or divide the surfaces "
                                   "into four-sided ones with Transfinite Surface"));
}

void check_named_curves(const MeshData<2>& mesh) {
  for (std::size_t i = 1; i < mesh.surfaces.size(); ++i)
    if (std::none_of(mesh.faces.begin(), mesh.faces.end(),
                     [&](const Face<2>& edge) { return edge.surface == i; }))
      throw std::invalid_argument(
          fmt::format("the physical curve \"{}\" holds no edge of a body's boundary: list the "
                      "curves that bound its surface",
                      mesh.surfaces[i]));
}

void scale(MeshData<2>& mesh, double length_unit) {
  for (Place& vertex : mesh.vertices)
    for (double& coordinate : vertex) coordinate *= length_unit;
  for (Circle& circle : mesh.circles) {
    for (double& coordinate : circle.centre) coordinate *= length_unit;
    circle.radius *= length_unit;
  }
}

/// The current Gmsh model with its names, after its mesh has been made or read.
MeshData<2> named_mesh(bool is_mesh_file) {
  check_cells(count_other_cells(), is_mesh_file);
  ModelLabels labels;
  label_bodies(labels);
  check_bodies(read_model(labels).mesh);  // before the curves: shared ones have two names
  label_curves(labels);
  MeshData<2> mesh = read_model(labels).mesh;
  check_named_curves(mesh);
  return mesh;
}

bool has_any_cells() {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, 2);
  return !types.empty();
}

/// Meshes the current model; if triangles remain, twice as coarse with each cell divided into
/// quadrilaterals.
void mesh_current_model() {
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::model::mesh::generate(2);
  if (count_other_cells().triangles == 0) return;
  double factor = 1.;
  gmsh::option::getNumber("Mesh.MeshSizeFactor", factor);
  gmsh::model::mesh::clear();
  gmsh::option::setNumber("Mesh.MeshSizeFactor", 2. * factor);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  gmsh::model::mesh::generate(2);
}

/// Throws what Gmsh reports while it runs an action.
void run(GmshSession& session, const std::function<void()>& action,
         const GuardedGeometry& geometry = {}) {
  Errors errors = session.errors_of(action);
  if (errors.empty()) return;
  for (std::string& error : errors) error = with_source(error, geometry);
  throw std::invalid_argument(listed(errors));
}

MeshData<2> read_geo(const std::filesystem::path& file) {
  const GuardedGeometry geometry = guard_geometry(file);
  // Gmsh opens only what this program has written to a place of its own: beside the user's file it
  // would also run "<file>.opt"
  const PrivateDirectory directory;
  for (std::size_t i = 0; i < geometry.meshes.size(); ++i) {
    const std::string content = read_file(geometry.meshes[i]);
    check_msh(content, geometry.meshes[i]);
    (void)directory.write(merged_name(i), content);
  }
  const std::filesystem::path guarded = directory.write("geometry.geo", geometry.text);
  GmshSession session;
  set_quadrilateral_options();
  MeshData<2> mesh;
  run(
      session, [&] { gmsh::open(guarded.string()); }, geometry);
  run(session, [&] {
    if (!has_any_cells()) mesh_current_model();
  });
  run(session, [&] { mesh = named_mesh(false); });
  return mesh;
}

MeshData<2> read_msh(const std::filesystem::path& file) {
  const std::string content = read_file(file);
  check_msh(content, file);
  const PrivateDirectory directory;
  const std::filesystem::path copy = directory.write("mesh.msh", content);
  GmshSession session;
  MeshData<2> mesh;
  run(session, [&] { gmsh::open(copy.string()); });
  run(session, [&] { mesh = named_mesh(true); });
  return mesh;
}

/// Runs an action; what it refuses gets the name of the file in front, unless it is there.
MeshData<2> naming(const std::filesystem::path& file, const std::function<MeshData<2>()>& action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    if (what.find(file.string()) != what.npos) throw;
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), what));
  }
}

}  // namespace

MeshData<2> read_geometry(const std::filesystem::path& file, double length_unit) {
  if (!(length_unit > 0.) || !std::isfinite(length_unit))
    throw std::invalid_argument(fmt::format("{}: its unit of length is {} m: it must be positive",
                                            file.string(), length_unit));
  const std::string extension = file.extension().string();
  if (extension != ".geo" && extension != ".msh")
    throw std::invalid_argument(
        fmt::format("{}: a geometry must be a .geo or a .msh file", file.string()));
  return naming(file, [&] {
    MeshData<2> mesh = extension == ".geo" ? read_geo(file) : read_msh(file);
    scale(mesh, length_unit);
    check(mesh);
    return mesh;
  });
}

}  // namespace geneva::mesh
