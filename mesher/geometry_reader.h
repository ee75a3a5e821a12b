#pragma once

#include <string>
#include <vector>

#include "mesh/mesher_exchange.h"

namespace geneva::mesher {

using mesh::MeshData;

/// A mesh in the file's unit of length, or the errors that kept it from being made.
template <int dim>
struct Reading {
  MeshData<dim> mesh;
  std::vector<std::string> errors;
};

/// Lets Gmsh open a geometry or mesh, meshes it if it has no cells, and reads it, see
/// mesh::read_geometry.
template <int dim>
Reading<dim> read_geometry(const mesh::GeometryTask& task);

}  // namespace geneva::mesher
