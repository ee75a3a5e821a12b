#pragma once

#include <mpi.h>

#include <filesystem>
#include <optional>

#include "mesh/mesher.h"

namespace geneva::app {

/// Searches for the crown radius (of a logarithmic profile: the amplitude) by which the line load
/// along the pin of a case in 3-D is most even, prints the pin before and after, and writes
/// crown.json.
///
/// The search runs on coarse meshes; before and after are solved as accurately as the case asks.
/// @param output where crown.json goes; empty: results in the case's directory
/// @param mesher on rank 0
/// @return the exit code: 0, or 2 if the accuracy was not reached
/// @throws base::InputError on all ranks if the case is wrong or its pin has a tabulated
/// profile
int design_crown(MPI_Comm communicator, const std::filesystem::path& case_directory,
                 const std::filesystem::path& output, std::optional<mesh::Mesher>& mesher);

}  // namespace geneva::app
