#include "mesher/element_blocks.h"

#include <gmsh.h>

#include <algorithm>
#include <string>

namespace geneva::mesher {

std::vector<ElementBlock> element_blocks(const int dimension, const int entity) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
  std::vector<ElementBlock> blocks;
  for (std::size_t i = 0; i < types.size(); ++i) {
    std::string name;
    int own_dimension = 0;
    int order = 0;
    int all = 0;
    int primary = 0;
    std::vector<double> places;
    gmsh::model::mesh::getElementProperties(types[i], name, own_dimension, order, all, places,
                                            primary);
    blocks.push_back({static_cast<std::size_t>(primary), static_cast<std::size_t>(all), order,
                      std::move(nodes[i])});
  }
  return blocks;
}

bool has_triangles() {
  const std::vector<ElementBlock> blocks = element_blocks(2);
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const ElementBlock& block) { return block.corners == 3; });
}

std::map<std::size_t, mesh::Place> places_of_nodes() {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<std::size_t, mesh::Place> place_of;
  for (std::size_t i = 0; i < tags.size(); ++i)
    place_of[tags[i]] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  return place_of;
}

}  // namespace geneva::mesher
