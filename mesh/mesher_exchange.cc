#include "mesh/mesher_exchange.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/errors.h"

namespace geneva::mesh {

namespace {

using loads::Loop;
using loads::Outline;
using loads::Point;
using loads::Segment;
using nlohmann::json;

[[noreturn]] void refuse(const std::string& what) {
  throw base::InputError("the mesher's answer is no mesh: " + what);
}

const json& list_of(const json& value, const char* const name) {
  const auto found = value.find(name);
  if (found == value.end() || !found->is_array()) refuse(fmt::format("its {} are missing", name));
  return *found;
}

/// @param count of the entries that it must have
const json& row_of(const json& value, const std::size_t count, const char* const what) {
  if (!value.is_array() || value.size() != count)
    refuse(fmt::format("a {} needs {} numbers", what, count));
  return value;
}

double number_of(const json& value, const char* const what) {
  if (!value.is_number()) refuse(fmt::format("a number of a {} is none", what));
  const double number = value.get<double>();
  if (!std::isfinite(number)) refuse(fmt::format("a number of a {} is not finite", what));
  return number;
}

unsigned int index_of(const json& value, const char* const what) {
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > std::numeric_limits<unsigned int>::max())
    refuse(fmt::format("an index of a {} is none", what));
  return value.get<unsigned int>();
}

int circle_index_of(const json& value) {
  constexpr int none = -1;
  if (value.is_number_integer() && value.get<std::int64_t>() == none) return none;
  const unsigned int index = index_of(value, "face");
  if (index > static_cast<unsigned int>(std::numeric_limits<int>::max()))
    refuse("an index of a face is none");
  return static_cast<int>(index);
}

std::vector<std::string> names_of(const json& value, const char* const name) {
  std::vector<std::string> names;
  for (const json& entry : list_of(value, name)) {
    if (!entry.is_string()) refuse(fmt::format("one of its {} has no name", name));
    names.push_back(entry.get<std::string>());
  }
  return names;
}

template <std::size_t n>
std::array<double, n> place_of(const json& row) {
  std::array<double, n> place{};
  for (std::size_t i = 0; i < n; ++i) place[i] = number_of(row[i], "vertex");
  return place;
}

Circle circle_of(const json& value) {
  const json& row = row_of(value, 8, "circle");
  std::array<double, 8> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number_of(row[i], "circle");
  const auto& [x, y, z, radius, ax, ay, az, ring_radius] = numbers;
  if (!(radius > 0.)) refuse("a radius is not positive");
  const double length = std::hypot(ax, ay, az);
  if (length != 0. && !(std::abs(length - 1.) < 1e-9)) refuse("an axis is not of length 1");
  if (!(ring_radius >= 0.)) refuse("the radius of a torus's ring is negative");
  return {{x, y, z}, radius, {ax, ay, az}, ring_radius};
}

json json_of(const Point& point) { return {point.x, point.y}; }

Point point_of(const json& value) { return {value.at(0).get<double>(), value.at(1).get<double>()}; }

json json_of(const Segment& segment) {
  return {{"start", json_of(segment.start)}, {"end", json_of(segment.end)},
          {"is_arc", segment.is_arc},        {"centre", json_of(segment.centre)},
          {"clockwise", segment.clockwise},  {"surface", segment.surface}};
}

Segment segment_of(const json& value) {
  return {point_of(value.at("start")),       point_of(value.at("end")),
          value.at("is_arc").get<bool>(),    point_of(value.at("centre")),
          value.at("clockwise").get<bool>(), value.at("surface").get<std::string>()};
}

json json_of(const MeshSizing& sizing) {
  return {{"general", sizing.general},
          {"at_contact", sizing.at_contact},
          {"contact", json_of(sizing.contact)},
          {"contact_distance", sizing.contact_distance}};
}

}  // namespace

json json_of(const OutlineTask& task) {
  json outlines = json::array();
  for (const Outline& outline : task.outlines) {
    json loops = json::array();
    for (const Loop& loop : outline.loops) {
      json segments = json::array();
      for (const Segment& segment : loop) segments.push_back(json_of(segment));
      loops.push_back(segments);
    }
    outlines.push_back({{"name", outline.name}, {"loops", loops}});
  }
  return {{"outlines", outlines}, {"sizing", json_of(task.sizing)}};
}

OutlineTask outline_task_of(const json& task) {
  OutlineTask result{};
  for (const json& given : task.at("outlines")) {
    Outline outline{given.at("name").get<std::string>(), {}};
    for (const json& segments : given.at("loops")) {
      Loop loop;
      for (const json& segment : segments) loop.push_back(segment_of(segment));
      outline.loops.push_back(loop);
    }
    result.outlines.push_back(outline);
  }
  const json& sizing = task.at("sizing");
  result.sizing = {sizing.at("general").get<double>(), sizing.at("at_contact").get<double>(),
                   point_of(sizing.at("contact")), sizing.at("contact_distance").get<double>()};
  return result;
}

json json_of(const GeometryTask& task) {
  json picks = json::array();
  for (const Pick& pick : task.picks)
    picks.push_back({{"name", pick.name}, {"is_body", pick.is_body}, {"place", pick.place}});
  return {{"dimension", task.dimension},
          {"directory", task.directory},
          {"file", task.file},
          {"kind", task.kind},
          {"circle_tolerance", task.circle_tolerance},
          {"bodies", task.bodies},
          {"picks", picks},
          {"cell_size", task.cell_size}};
}

GeometryTask geometry_task_of(const json& task) {
  GeometryTask result{task.at("dimension").get<int>(),
                      task.at("directory").get<std::string>(),
                      task.at("file").get<std::string>(),
                      task.at("kind").get<FileKind>(),
                      task.at("circle_tolerance").get<double>(),
                      task.at("bodies").get<std::vector<std::string>>(),
                      {},
                      task.at("cell_size").get<double>()};
  for (const json& pick : task.at("picks"))
    result.picks.push_back({pick.at("name").get<std::string>(), pick.at("is_body").get<bool>(),
                            pick.at("place").get<std::array<double, 3>>()});
  return result;
}

template <int dim>
json json_of(const MeshData<dim>& mesh) {
  json cells = json::array();
  for (const Cell<dim>& cell : mesh.cells) {
    json row = cell.vertices;
    row.push_back(cell.body);
    cells.push_back(std::move(row));
  }
  json faces = json::array();
  for (const Face<dim>& face : mesh.faces) {
    json row = face.vertices;
    row.push_back(face.surface);
    row.push_back(face.circle);
    faces.push_back(std::move(row));
  }
  json circles = json::array();
  for (const Circle& circle : mesh.circles) {
    json row = circle.centre;
    row.push_back(circle.radius);
    for (const double component : circle.axis) row.push_back(component);
    row.push_back(circle.ring_radius);
    circles.push_back(std::move(row));
  }
  return {{"dimension", dim},         {"vertices", mesh.vertices}, {"cells", cells},
          {"faces", faces},           {"circles", circles},        {"bodies", mesh.bodies},
          {"surfaces", mesh.surfaces}};
}

template <int dim>
MeshData<dim> mesh_of(const json& given) {
  if (!given.is_object() || given.value("dimension", json()) != json(dim))
    refuse(fmt::format("it is not one in {} dimensions", dim));
  MeshData<dim> mesh;
  for (const json& vertex : list_of(given, "vertices"))
    mesh.vertices.push_back(place_of<static_cast<std::size_t>(dim)>(row_of(vertex, dim, "vertex")));
  for (const json& row : list_of(given, "cells")) {
    Cell<dim> cell{};
    const std::size_t corners = cell.vertices.size();
    (void)row_of(row, corners + 1, "cell");
    for (std::size_t i = 0; i < corners; ++i) cell.vertices[i] = index_of(row[i], "cell");
    cell.body = index_of(row[corners], "cell");
    mesh.cells.push_back(cell);
  }
  for (const json& row : list_of(given, "faces")) {
    Face<dim> face{};
    const std::size_t corners = face.vertices.size();
    (void)row_of(row, corners + 2, "face");
    for (std::size_t i = 0; i < corners; ++i) face.vertices[i] = index_of(row[i], "face");
    face.surface = index_of(row[corners], "face");
    face.circle = circle_index_of(row[corners + 1]);
    mesh.faces.push_back(face);
  }
  for (const json& circle : list_of(given, "circles")) mesh.circles.push_back(circle_of(circle));
  mesh.bodies = names_of(given, "bodies");
  mesh.surfaces = names_of(given, "surfaces");
  if (mesh.surfaces.empty()) refuse("it has no surfaces");
  return mesh;
}

template json json_of(const MeshData<2>&);
template json json_of(const MeshData<3>&);
template MeshData<2> mesh_of(const json&);
template MeshData<3> mesh_of(const json&);

}  // namespace geneva::mesh
