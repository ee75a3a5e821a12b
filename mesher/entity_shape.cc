#include "mesher/entity_shape.h"

#include <gmsh.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesh/round_shapes.h"
#include "mesher/element_blocks.h"

namespace geneva::mesher {

using mesh::MayBe;
using mesh::Place;
using mesh::SurfaceNormal;

namespace {

std::vector<Place> as_places(const std::vector<double>& coordinates) {
  std::vector<Place> places;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    places.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  return places;
}

Place difference(const Place& one, const Place& other) {
  return {one[0] - other[0], one[1] - other[1], one[2] - other[2]};
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

/// Nodes of a curve of a mesh, its ends last.
std::vector<Place> nodes_of_curve(const int curve) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, 1, curve, true);
  return as_places(coordinates);
}

/// Nodes of the elements of a curve or surface; a file may not say which of them bound it.
std::set<std::size_t> nodes_of_elements(const int dimension, const int entity) {
  std::set<std::size_t> nodes;
  for (const ElementBlock& block : element_blocks(dimension, entity))
    nodes.insert(block.nodes.begin(), block.nodes.end());
  return nodes;
}

std::vector<Place> nodes_of_surface(const int surface) {
  const std::map<std::size_t, Place> place_of = places_of_nodes();
  std::vector<Place> places;
  for (const std::size_t node : nodes_of_elements(2, surface)) places.push_back(place_of.at(node));
  return places;
}

/// Normals of a surface's cells, at their middles: the cross products of two edges of a triangle,
/// of the diagonals of a quadrilateral.
std::vector<SurfaceNormal> facet_normals(const int surface) {
  const std::map<std::size_t, Place> place_of = places_of_nodes();
  std::vector<SurfaceNormal> normals;
  for (const ElementBlock& block : element_blocks(2, surface))
    for (std::size_t i = 0; i < block.nodes.size(); i += block.nodes_of_one) {
      const auto corner = [&](const std::size_t k) -> const Place& {
        return place_of.at(block.nodes[i + k]);
      };
      const bool is_triangle = block.corners == 3;
      const Place u = difference(corner(is_triangle ? 1 : 2), corner(0));
      const Place v = difference(corner(is_triangle ? 2 : 3), corner(is_triangle ? 0 : 1));
      Place middle{};
      for (std::size_t k = 0; k < block.corners; ++k)
        for (std::size_t c = 0; c < 3; ++c)
          middle[c] += corner(k)[c] / static_cast<double>(block.corners);
      normals.push_back(
          {middle,
           {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}});
    }
  return normals;
}

/// Normals of a surface of a geometry at its sample points.
std::vector<SurfaceNormal> sample_normals(const int surface) {
  std::vector<double> directions;
  gmsh::model::getNormal(surface, sample_parameters(2, surface), directions);
  const std::vector<Place> places = sample_points(2, surface);
  std::vector<SurfaceNormal> normals;
  for (const Place& direction : as_places(directions))
    normals.push_back({places.at(normals.size()), direction});
  return normals;
}

/// Whether a surface of a mesh has a node that is not a corner of an element at its outline.
bool has_inner_node(const int surface) {
  std::map<std::pair<std::size_t, std::size_t>, int> facets_at;
  std::set<std::size_t> inner;
  for (const ElementBlock& block : element_blocks(2, surface)) {
    if (block.order > 1) return true;
    for (std::size_t i = 0; i < block.nodes.size(); i += block.nodes_of_one)
      for (std::size_t k = 0; k < block.corners; ++k) {
        const std::size_t begin = block.nodes[i + k];
        const std::size_t end = block.nodes[i + (k + 1) % block.corners];
        ++facets_at[std::minmax(begin, end)];
        inner.insert(begin);
      }
  }
  for (const auto& [edge, facets] : facets_at)
    if (facets == 1) {
      inner.erase(edge.first);
      inner.erase(edge.second);
    }
  return !inner.empty();
}

/// Points of a curve or surface, and for a surface its normals.
struct ShapePoints {
  std::vector<Place> points;
  std::vector<SurfaceNormal> normals;
  MayBe may_be;
};

/// @return none of a straight line or plane
template <int dim>
ShapePoints shape_points(const int entity) {
  std::string type;
  gmsh::model::getType(dim - 1, entity, type);
  if (type == "Line" || type == "Plane") return {};
  const bool is_discrete = type.rfind("Discrete", 0) == 0;
  if constexpr (dim == 2)
    return {is_discrete ? nodes_of_curve(entity) : sample_points(1, entity), {}, MayBe::any_shape};
  if (is_discrete)
    return {nodes_of_surface(entity), facet_normals(entity),
            has_inner_node(entity) ? MayBe::any_shape : MayBe::no_sphere};
  return {sample_points(2, entity), sample_normals(entity), MayBe::any_shape};
}

template <int dim>
std::optional<Circle> exact_shape(const ShapePoints& of) {
  return dim == 2 ? mesh::circle_through(of.points)
                  : mesh::round_surface_through(of.points, of.normals, of.may_be);
}

template <int dim>
std::optional<Circle> near_shape(const ShapePoints& of, const double tolerance) {
  return dim == 2 ? mesh::circle_near(of.points, tolerance)
                  : mesh::round_surface_near(of.points, of.normals, tolerance, of.may_be);
}

/// Round curves or surfaces that have one circle.
struct RoundGroup {
  std::vector<int> entities;
  std::set<std::size_t> nodes;
  ShapePoints points;
  Circle circle;
  bool is_fitted;
};

template <int dim>
std::vector<RoundGroup> single_groups(const double tolerance) {
  std::vector<RoundGroup> groups;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dim - 1);
  for (const auto& [dimension, entity] : entities) {
    const ShapePoints points = shape_points<dim>(entity);
    const std::optional<Circle> exact = exact_shape<dim>(points);
    const std::optional<Circle> shape =
        exact || tolerance == 0. ? exact : near_shape<dim>(points, tolerance);
    if (!shape) continue;
    groups.push_back({{entity}, nodes_of_elements(dim - 1, entity), points, *shape, !exact});
  }
  return groups;
}

bool have_common_nodes(const RoundGroup& one, const RoundGroup& other) {
  return std::any_of(one.nodes.begin(), one.nodes.end(),
                     [&](const std::size_t node) { return other.nodes.count(node) > 0; });
}

ShapePoints together(ShapePoints one, const ShapePoints& other) {
  one.points.insert(one.points.end(), other.points.begin(), other.points.end());
  one.normals.insert(one.normals.end(), other.normals.begin(), other.normals.end());
  if (other.may_be == MayBe::any_shape) one.may_be = MayBe::any_shape;
  return one;
}

/// The circle of two groups, of which one at least is fitted; nothing if they have none.
template <int dim>
std::optional<Circle> common_circle(const RoundGroup& one, const RoundGroup& other,
                                    const double tolerance) {
  if (one.is_fitted && other.is_fitted)
    return near_shape<dim>(together(one.points, other.points), tolerance);
  const RoundGroup& exact = one.is_fitted ? other : one;
  const RoundGroup& fitted = one.is_fitted ? one : other;
  return mesh::all_on(exact.circle, fitted.points.points, tolerance) ? std::optional(exact.circle)
                                                                     : std::nullopt;
}

/// Joins a group with the first later one that has its circle.
/// @return whether there was one
template <int dim>
bool join_two(std::vector<RoundGroup>& groups, const double tolerance) {
  for (auto one = groups.begin(); one != groups.end(); ++one)
    for (auto other = one + 1; other != groups.end(); ++other) {
      if (!(one->is_fitted || other->is_fitted) || !have_common_nodes(*one, *other)) continue;
      const std::optional<Circle> circle = common_circle<dim>(*one, *other, tolerance);
      if (!circle) continue;
      one->circle = *circle;
      one->is_fitted = one->is_fitted && other->is_fitted;
      one->entities.insert(one->entities.end(), other->entities.begin(), other->entities.end());
      one->nodes.insert(other->nodes.begin(), other->nodes.end());
      one->points = together(one->points, other->points);
      groups.erase(other);
      return true;
    }
  return false;
}

}  // namespace

template <int dim>
std::map<int, RoundEntity> round_entities(const double tolerance) {
  std::vector<RoundGroup> groups = single_groups<dim>(tolerance);
  std::map<int, RoundEntity> result;
  for (const RoundGroup& group : groups)
    result[group.entities.front()] = {group.circle, group.is_fitted};
  while (join_two<dim>(groups, tolerance)) continue;
  for (const RoundGroup& group : groups)
    for (const int entity : group.entities) result[entity].circle = group.circle;
  return result;
}

template std::map<int, RoundEntity> round_entities<2>(double);
template std::map<int, RoundEntity> round_entities<3>(double);

}  // namespace geneva::mesher
