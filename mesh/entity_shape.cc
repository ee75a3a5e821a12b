#include "mesh/entity_shape.h"

#include <gmsh.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/model_reader.h"
#include "mesh/round_shapes.h"

namespace geneva::mesh {

namespace {

std::vector<Place> as_places(const std::vector<double>& coordinates) {
  std::vector<Place> places;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    places.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  return places;
}

/// Evenly spaced parameters of a curve or surface of a geometry, point by point.
std::vector<double> sample_parameters(const int dimension, const int entity) {
  std::vector<double> low;
  std::vector<double> high;
  gmsh::model::getParametrizationBounds(dimension, entity, low, high);
  const int intervals = 6;
  const auto value = [&](const std::size_t direction, const int i) {
    return low.at(direction) + (high.at(direction) - low.at(direction)) * i / intervals;
  };
  std::vector<double> parameters;
  for (int i = 0; i <= intervals; ++i) {
    if (dimension == 1) parameters.push_back(value(0, i));
    for (int k = 0; dimension == 2 && k <= intervals; ++k) {
      parameters.push_back(value(0, i));
      parameters.push_back(value(1, k));
    }
  }
  return parameters;
}

/// Points of a curve or surface of a geometry.
std::vector<Place> sample_points(const int dimension, const int entity) {
  std::vector<double> places;
  gmsh::model::getValue(dimension, entity, sample_parameters(dimension, entity), places);
  return as_places(places);
}

/// Places of all nodes, by tag.
std::map<std::size_t, Place> places_of_nodes() {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  const std::vector<Place> places = as_places(coordinates);
  std::map<std::size_t, Place> place_of;
  for (std::size_t i = 0; i < tags.size(); ++i) place_of[tags[i]] = places[i];
  return place_of;
}

/// Nodes of a curve of a mesh, its ends last.
std::vector<Place> nodes_of_curve(const int curve) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, 1, curve, true);
  return as_places(coordinates);
}

/// Nodes of the elements of a surface of a mesh; a file may not say which of them bound it.
std::vector<Place> nodes_of_surface(const int surface) {
  const std::vector<std::size_t> nodes = element_nodes(2, surface, quad_type);
  const std::map<std::size_t, Place> place_of = places_of_nodes();
  std::vector<Place> places;
  for (const std::size_t node : std::set<std::size_t>(nodes.begin(), nodes.end()))
    places.push_back(place_of.at(node));
  return places;
}

/// Normals of a surface's quadrilaterals: the cross products of their diagonals.
std::vector<Place> facet_normals(const int surface) {
  const std::map<std::size_t, Place> place_of = places_of_nodes();
  const std::vector<std::size_t> nodes = element_nodes(2, surface, quad_type);
  std::vector<Place> normals;
  for (std::size_t i = 0; i + 3 < nodes.size(); i += 4) {
    const Place& p = place_of.at(nodes[i]);
    const Place& q = place_of.at(nodes[i + 1]);
    const Place& r = place_of.at(nodes[i + 2]);
    const Place& t = place_of.at(nodes[i + 3]);
    const Place u{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    const Place v{t[0] - q[0], t[1] - q[1], t[2] - q[2]};
    normals.push_back(
        {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]});
  }
  return normals;
}

/// Normals of a surface of a geometry at its sample points.
std::vector<Place> sample_normals(const int surface) {
  std::vector<double> normals;
  gmsh::model::getNormal(surface, sample_parameters(2, surface), normals);
  return as_places(normals);
}

}  // namespace

template <int dim>
std::optional<Circle> shape_of(const int entity) {
  std::string type;
  gmsh::model::getType(dim - 1, entity, type);
  if (type == "Line" || type == "Plane") return std::nullopt;
  const bool is_discrete = type.rfind("Discrete", 0) == 0;
  if constexpr (dim == 2) {
    return circle_through(is_discrete ? nodes_of_curve(entity) : sample_points(1, entity));
  } else {
    if (is_discrete) return round_surface_through(nodes_of_surface(entity), facet_normals(entity));
    return round_surface_through(sample_points(2, entity), sample_normals(entity));
  }
}

template std::optional<Circle> shape_of<2>(int);
template std::optional<Circle> shape_of<3>(int);

}  // namespace geneva::mesh
