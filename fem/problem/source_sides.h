#pragma once

#include <string>

#include "fem/problem/problem.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Compliance of a body's surface up to a common factor [1/Pa]: (1 - nu^2)/E, or 1/E in plane
/// stress.
/// @param surface of one body
template <int dim>
double compliance(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                  const std::string& surface);

/// Poisson's ratio of the bodies of a pair, in the mean by their compliance; in plane stress that
/// of plane strain with the same in-plane stresses, nu/(1 + nu).
template <int dim>
double mean_poissons_ratio(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                           const ContactPair& pair);

/// Makes the softer body's surface the source of every pair.
///
/// Where the nodes of two equally fine surfaces lie between each other, pressures that alternate
/// from node to node move the target by next to nothing. What resists them is the compliance of the
/// source alone, so that those of a stiff one are the noisier. Pairs of equally stiff bodies stay
/// as they are, and those whose target is in another pair, too.
/// @param problem with its bodies in the mesh's order
template <int dim>
void take_softer_sources(Problem<dim>& problem, const mesh::MeshData<dim>& mesh);

}  // namespace geneva::fem
