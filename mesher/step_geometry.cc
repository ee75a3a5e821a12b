#include "mesher/step_geometry.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "cad/nearest.h"
#include "cad/step_names.h"

namespace geneva::mesher {

namespace {

using cad::Measure;

constexpr double millimetres = 1e3;  // of a metre

std::vector<cad::PlacedName> picks_of(const mesh::GeometryTask& task) {
  std::vector<cad::PlacedName> picks;
  for (const auto& [name, is_body, place] : task.picks)
    picks.push_back(
        {name, is_body, {millimetres * place[0], millimetres * place[1], millimetres * place[2]}});
  return picks;
}

double distance(const std::array<double, 3>& one, const std::array<double, 3>& other) {
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

Measure measure_of(const int dimension, const int entity) {
  Measure result{};
  gmsh::model::occ::getMass(dimension, entity, result.size);
  gmsh::model::occ::getCenterOfMass(dimension, entity, result.middle[0], result.middle[1],
                                    result.middle[2]);
  return result;
}

/// Relative difference of size and middle.
double difference(const Measure& found, const Measure& wanted, const int dimension) {
  return distance(found.middle, wanted.middle) / std::pow(wanted.size, 1. / dimension) +
         std::abs(found.size - wanted.size) / wanted.size;
}

/// Gmsh's tag of a shape among some entities, from which it is taken, so that of two alike each
/// is found once.
int take_tag_of(const TopoDS_Shape& shape, gmsh::vectorpair& entities) {
  const Measure wanted = cad::measure(shape);
  std::vector<double> differences;
  for (const auto& [dimension, entity] : entities)
    differences.push_back(difference(measure_of(dimension, entity), wanted, dimension));
  const auto best = std::min_element(differences.begin(), differences.end());
  constexpr double rounding = 1e-3;  // both measure curved shapes by quadrature
  if (best == differences.end() || *best > rounding)
    throw std::logic_error("Gmsh does not know a face of the STEP file");
  const auto entity = entities.begin() + (best - differences.begin());
  const int tag = entity->second;
  entities.erase(entity);
  return tag;
}

void add_group(const int dimension, const std::vector<int>& entities, const std::string& name) {
  const int group = gmsh::model::addPhysicalGroup(dimension, entities);
  gmsh::model::setPhysicalName(dimension, group, name);
}

}  // namespace

template <int dim>
void read_step_model(const mesh::GeometryTask& task) {
  const std::filesystem::path file = std::filesystem::path(task.directory) / task.file;
  std::map<std::string, std::vector<int>> surfaces;
  std::map<std::string, std::vector<int>> bodies;
  gmsh::model::add("step");
  for (const cad::SelectedBody& body :
       cad::select(cad::read_step(file), dim, task.bodies, picks_of(task))) {
    gmsh::vectorpair imported;
    gmsh::model::occ::importShapesNativePointer(&body.shape, imported);
    gmsh::model::occ::synchronize();
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary(imported, boundary, false, false);
    bodies[body.name].push_back(imported.at(0).second);
    for (const auto& [shape, surface] : body.boundary)
      surfaces[surface].push_back(take_tag_of(shape, boundary));
  }
  for (const auto& [name, entities] : bodies) add_group(dim, entities, name);
  for (const auto& [name, entities] : surfaces) add_group(dim - 1, entities, name);
}

template <int dim>
void mesh_step_model(const double cell_size, const double factor) {
  constexpr double cells_across = 6.;
  constexpr double cells_around = 6.;  // of a turn, before they are halved
  gmsh::model::mesh::clear();
  gmsh::vectorpair bodies;
  gmsh::model::getEntities(bodies, dim);
  for (const auto& body : bodies) {
    gmsh::vectorpair points;
    gmsh::model::getBoundary({body}, points, false, false, true);
    const double extent = std::pow(measure_of(dim, body.second).size, 1. / dim);
    gmsh::model::mesh::setSize(points,
                               2. * factor * (cell_size > 0. ? cell_size : extent / cells_across));
  }
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", std::ceil(cells_around / factor));
  gmsh::option::setNumber("Mesh.RecombineAll", 0);
  gmsh::option::setNumber("Mesh.RandomSeed", 1);
  gmsh::model::mesh::generate(dim);
  gmsh::model::mesh::setOrder(2);
}

template void read_step_model<2>(const mesh::GeometryTask&);
template void read_step_model<3>(const mesh::GeometryTask&);
template void mesh_step_model<2>(double, double);
template void mesh_step_model<3>(double, double);

}  // namespace geneva::mesher
