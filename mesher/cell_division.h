#pragma once

namespace geneva::mesher {

/// Makes linear quadrilaterals or hexahedra of all cells of Gmsh's current mesh, and linear lines
/// or quadrilaterals of the faces that are in entities.
///
/// If there are triangles, tetrahedra or prisms, each cell is divided into as many parts as it has
/// corners: a part has the corner, the middles of the edges and faces that meet there, and the
/// middle of the cell. Where cells are of order 2, the middles of edges are their nodes, and those
/// of faces and cells follow from their shape functions. If all cells are quadrilaterals or
/// hexahedra, those of order 2 lose their middle nodes.
/// @return whether cells were divided: the new nodes are only near to curved surfaces
/// @throws base::InputError for pyramids, cells of order 3 and more
template <int dim>
bool divide_cells();

}  // namespace geneva::mesher
