#pragma once

#include <string>

#include "base/errors.h"
#include "fem/problem/problem.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Part of a problem.
enum class ProblemPart { bodies, supports, loads, pairs };

/// A part of a problem that does not fit the mesh or another part.
class ProblemError : public base::InputError {
 public:
  ProblemError(const ProblemPart where, const std::string& why)
      : base::InputError(why), part(where) {}

  ProblemPart part;
};

/// Puts the problem's bodies in the order of the mesh's.
/// @throws ProblemError if a body of the mesh has no material, or a material no body
template <int dim>
void order_bodies(Problem<dim>& problem, const mesh::MeshData<dim>& mesh);

/// Checks that every name in the problem is in the mesh, that contact surfaces do not overlap and
/// that every body is held or touched.
/// @throws ProblemError naming what is missing and what there is
template <int dim>
void check(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh);

}  // namespace geneva::fem
