#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "loads/wheel/outline.h"
#include "mesh/file_kind.h"
#include "mesh/mesh_data.h"
#include "mesh/mesh_sizing.h"
#include "mesh/pick.h"

namespace geneva::mesh {

/// Outlines to be meshed.
struct OutlineTask {
  std::vector<loads::Outline> outlines;
  MeshSizing sizing;
};

/// A geometry to be meshed, or a mesh to be read.
struct GeometryTask {
  int dimension;          ///< 2 or 3
  std::string directory;  ///< absolute, which holds the file and all that it includes
  std::string file;       ///< its name in there
  FileKind kind;
  double circle_tolerance;               ///< see read_geometry
  std::vector<std::string> bodies = {};  ///< of a STEP file those that are wanted; none: all
  std::vector<Pick> picks = {};          ///< in a STEP file
  double cell_size = 0.;  ///< of a STEP file's coarse cells [m]; 0: what suits each body
};

/// No coarse mesh of hundreds or thousands of cells takes longer [s].
inline constexpr double longest_meshing = 600.;

/// How much the mesher may take.
struct MesherLimits {
  double memory;   ///< [byte], > 0
  double seconds;  ///< > 0
};

/// What the mesher says: a mesh, or why there is none.
struct MesherAnswer {   // NOLINT(bugprone-exception-escape): that of nlohmann-json's own end
  nlohmann::json mesh;  ///< see mesh_of; null if there are errors
  std::vector<std::string> errors;  ///< empty if there is a mesh
};

// Between geneva and its mesher everything goes as JSON: a text, in which numbers are exact to the
// last bit and infinite ones cannot be written.

nlohmann::json json_of(const OutlineTask& task);
nlohmann::json json_of(const GeometryTask& task);
OutlineTask outline_task_of(const nlohmann::json& task);
GeometryTask geometry_task_of(const nlohmann::json& task);

template <int dim>
nlohmann::json json_of(const MeshData<dim>& mesh);

/// A mesh from a program that is not trusted.
/// @throws base::InputError unless it is one: members, their kinds and lengths, finite
/// coordinates, whole numbers that are no negative index, positive radii, axes of length 1 or 0.
/// What they refer to is for check().
template <int dim>
MeshData<dim> mesh_of(const nlohmann::json& mesh);

}  // namespace geneva::mesh
