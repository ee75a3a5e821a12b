#include "mesher/cell_division.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/errors.h"
#include "mesher/element_blocks.h"
#include "mesher/model_reader.h"

namespace geneva::mesher {

namespace {

using mesh::Place;
using Nodes = std::vector<std::size_t>;
/// Corners of an edge or face, in ascending order.
using Key = std::vector<std::size_t>;
using Loops = std::vector<std::vector<std::size_t>>;
using Edges = std::vector<std::array<std::size_t, 2>>;

/// Faces of a cell as loops of its corners; of a plane cell itself.
const Loops& faces_of(const int dimension, const std::size_t corners) {
  static const Loops triangle{{0, 1, 2}};
  static const Loops quadrilateral{{0, 1, 2, 3}};
  static const Loops tetrahedron{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  static const Loops prism{{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  static const Loops hexahedron{{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  if (dimension == 2) return corners == 3 ? triangle : quadrilateral;
  return corners == 4 ? tetrahedron : corners == 6 ? prism : hexahedron;
}

/// Edges of a cell in the order in which Gmsh numbers the nodes in their middles.
const Edges& edges_of(const int dimension, const std::size_t corners) {
  static const Edges line{{0, 1}};
  static const Edges triangle{{0, 1}, {1, 2}, {2, 0}};
  static const Edges quadrilateral{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  static const Edges tetrahedron{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {2, 3}, {1, 3}};
  static const Edges prism{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};
  static const Edges hexahedron{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
  if (dimension == 1) return line;
  if (dimension == 2) return corners == 3 ? triangle : quadrilateral;
  return corners == 4 ? tetrahedron : corners == 6 ? prism : hexahedron;
}

Key key_of(Nodes nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// The nodes in the middles of edges, faces and cells, those that there are and new ones.
class Middles {
 public:
  explicit Middles(std::map<std::size_t, Place> places)
      : places_(std::move(places)), last_(places_.empty() ? 0 : places_.rbegin()->first) {}

  /// Takes the middle nodes of cells of order 2.
  void take(const int dimension, const ElementBlock& block) {
    if (block.order < 2) return;
    const Edges& edges = edges_of(dimension, block.corners);
    for (auto cell = block.nodes.begin(); cell != block.nodes.end();
         cell += static_cast<std::ptrdiff_t>(block.nodes_of_one))
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto node = [&](const std::size_t k) {
          return *(cell + static_cast<std::ptrdiff_t>(k));
        };
        middles_.emplace(key_of({node(edges[i][0]), node(edges[i][1])}), node(block.corners + i));
      }
  }

  std::size_t of_edge(const std::size_t one, const std::size_t other) {
    return found_or_made(key_of({one, other}), [&] { return mean({one, other}); });
  }

  /// By the shape functions of a triangle of order 2 at its middle, sums of 4/9 of the middles of
  /// its edges less 1/9 of its corners; of a quadrilateral by serendipity ones.
  std::size_t of_face(const Nodes& loop) {
    return found_or_made(key_of(loop), [&] {
      Nodes middles;
      for (std::size_t i = 0; i < loop.size(); ++i)
        middles.push_back(of_edge(loop[i], loop[(i + 1) % loop.size()]));
      const double corner = loop.size() == 3 ? -1. / 3. : -1.;
      return weighted(mean(middles), 1. - corner, mean(loop), corner);
    });
  }

  /// Inside: the mean of the middles of its edges.
  std::size_t of_cell(const Nodes& corners, const Edges& edges) {
    Nodes middles;
    for (const auto& [one, other] : edges) middles.push_back(of_edge(corners[one], corners[other]));
    return made(mean(middles));
  }

  [[nodiscard]] const std::map<std::size_t, Place>& places() const { return places_; }

 private:
  [[nodiscard]] Place mean(const Nodes& nodes) const {
    Place sum{};
    for (const std::size_t node : nodes)
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] += places_.at(node)[i] / static_cast<double>(nodes.size());
    return sum;
  }

  static Place weighted(const Place& one, const double weight, const Place& other,
                        const double other_weight) {
    Place result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = weight * one[i] + other_weight * other[i];
    return result;
  }

  template <typename Make>
  std::size_t found_or_made(const Key& key, const Make& make) {
    if (const auto found = middles_.find(key); found != middles_.end()) return found->second;
    return middles_[key] = made(make());
  }

  std::size_t made(const Place& place) {
    places_[++last_] = place;
    return last_;
  }

  std::map<std::size_t, Place> places_;
  std::size_t last_;
  std::map<Key, std::size_t> middles_;
};

/// Both halves of a line.
void divide_line(const Nodes& line, Middles& middles, Nodes& parts) {
  const std::size_t middle = middles.of_edge(line[0], line[1]);
  parts.insert(parts.end(), {line[0], middle, middle, line[1]});
}

/// A quadrilateral at each corner of a face.
void divide_face(const Nodes& loop, Middles& middles, Nodes& parts) {
  const std::size_t n = loop.size();
  const std::size_t centre = middles.of_face(loop);
  for (std::size_t i = 0; i < n; ++i)
    parts.insert(parts.end(), {loop[i], middles.of_edge(loop[i], loop[(i + 1) % n]), centre,
                               middles.of_edge(loop[(i + n - 1) % n], loop[i])});
}

/// A hexahedron at each corner of a cell, where three edges and faces meet.
void divide_solid(const Nodes& corners, Middles& middles, Nodes& parts) {
  const Edges& edges = edges_of(3, corners.size());
  const std::size_t centre = middles.of_cell(corners, edges);
  const auto face_with = [&](const std::size_t a, const std::size_t b, const std::size_t c) {
    for (const auto& face : faces_of(3, corners.size())) {
      const auto has = [&](const std::size_t corner) {
        return std::find(face.begin(), face.end(), corner) != face.end();
      };
      if (!has(a) || !has(b) || !has(c)) continue;
      Nodes loop;
      for (const std::size_t corner : face) loop.push_back(corners[corner]);
      return middles.of_face(loop);
    }
    throw std::logic_error("two edges of a cell have no face");
  };
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    std::vector<std::size_t> ends;
    for (const auto& [one, other] : edges)
      if (one == corner || other == corner) ends.push_back(one == corner ? other : one);
    const auto edge = [&](const std::size_t i) {
      return middles.of_edge(corners[corner], corners[ends[i]]);
    };
    const auto face = [&](const std::size_t i, const std::size_t k) {
      return face_with(corner, ends[i], ends[k]);
    };
    parts.insert(parts.end(), {corners[corner], edge(0), face(0, 1), edge(1), edge(2), face(0, 2),
                               centre, face(1, 2)});
  }
}

Nodes divided(const int dimension, const ElementBlock& block, Middles& middles) {
  Nodes parts;
  for (std::size_t begin = 0; begin < block.nodes.size(); begin += block.nodes_of_one) {
    const auto first = block.nodes.begin() + static_cast<std::ptrdiff_t>(begin);
    const Nodes corners(first, first + static_cast<std::ptrdiff_t>(block.corners));
    if (dimension == 1)
      divide_line(corners, middles, parts);
    else if (dimension == 2)
      divide_face(corners, middles, parts);
    else
      divide_solid(corners, middles, parts);
  }
  return parts;
}

template <int dim>
void check_blocks(const std::vector<ElementBlock>& blocks) {
  for (const ElementBlock& block : blocks) {
    if (block.order > 2)
      throw base::InputError(
          fmt::format("cells are of order {}: linear ones and those of order 2 can be used; set "
                      "Mesh.ElementOrder = 1 (curved boundaries are followed while refining)",
                      block.order));
    if (dim == 3 && block.corners == 5)
      throw base::InputError(
          "there are pyramids, which cannot be divided into hexahedra: mesh with tetrahedra, "
          "prisms and hexahedra only");
  }
}

/// Entities of a dimension with their cells, divided.
std::map<int, Nodes> divided_entities(const int dimension, Middles& middles) {
  std::map<int, Nodes> result;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dimension);
  for (const auto& [own_dimension, entity] : entities)
    for (const ElementBlock& block : element_blocks(dimension, entity)) {
      const Nodes parts = divided(dimension, block, middles);
      result[entity].insert(result[entity].end(), parts.begin(), parts.end());
    }
  return result;
}

void add_cells(const int dimension, const std::map<int, Nodes>& cells_of) {
  const int type = dimension == 1 ? line_type : dimension == 2 ? quad_type : hexahedron_type;
  for (const auto& [entity, nodes] : cells_of)
    gmsh::model::mesh::addElementsByType(entity, type, {}, nodes);
}

template <int dim>
void divide_all() {
  Middles middles(places_of_nodes());
  for (const int dimension : {dim - 1, dim})
    for (const ElementBlock& block : element_blocks(dimension)) middles.take(dimension, block);
  const std::map<int, Nodes> faces = divided_entities(dim - 1, middles);
  const std::map<int, Nodes> cells = divided_entities(dim, middles);
  gmsh::model::mesh::clear();
  Nodes tags;
  std::vector<double> coordinates;
  for (const auto& [tag, place] : middles.places()) {
    tags.push_back(tag);
    coordinates.insert(coordinates.end(), place.begin(), place.end());
  }
  gmsh::model::mesh::addNodes(dim, cells.begin()->first, tags, coordinates);
  add_cells(dim - 1, faces);
  add_cells(dim, cells);
}

}  // namespace

template <int dim>
bool divide_cells() {
  const std::vector<ElementBlock> blocks = element_blocks(dim);
  check_blocks<dim>(blocks);
  const bool is_uniform = std::all_of(blocks.begin(), blocks.end(), [](const auto& block) {
    return block.corners == std::size_t{1} << dim;
  });
  if (!is_uniform) {
    divide_all<dim>();
    return true;
  }
  const bool is_linear =
      std::all_of(blocks.begin(), blocks.end(), [](const auto& block) { return block.order == 1; });
  if (!is_linear) gmsh::model::mesh::setOrder(1);
  return false;
}

template bool divide_cells<2>();
template bool divide_cells<3>();

}  // namespace geneva::mesher
