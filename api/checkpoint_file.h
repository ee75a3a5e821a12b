#pragma once

#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "fem/checkpoint.h"
#include "mesh/mesh_data.h"
#include "model/input/case_file.h"
#include "post/analysis/figures.h"

namespace geneva::api {

/// What a run needs to go on from a mesh that an earlier one has solved.
template <int dim>
struct SavedRun {
  fem::Checkpoint<dim> state;
  std::vector<post::RunFigures> figures;  ///< by mesh
};

/// Where a run that has not ended keeps its checkpoint: beside its results directory.
/// @throws base::InputError as base::resolved()
std::filesystem::path unfinished_checkpoint(const std::filesystem::path& results);

/// As it stands in the file: a line that marks it, with a checksum of what follows; a line of JSON;
/// the numbers of cells, nodes and displacements.
/// @param mesh coarse
template <int dim>
std::string checkpoint_text(const model::Case& given, const mesh::MeshData<dim>& mesh,
                            const SavedRun<dim>& run);

/// The unfinished checkpoint of a results directory or, if there is none, that within it; rank 0
/// reads, all ranks get it.
/// @throws base::InputError on all ranks if there is none, if it is damaged, of another program, or
/// of a case that differs in more than accuracy, limits and names: naming the difference
std::string read_checkpoint(MPI_Comm communicator, const std::filesystem::path& results,
                            const model::Case& given);

/// The run that a text of read_checkpoint() stands for.
/// @throws base::InputError if the coarse mesh differs, or the text is not a run's
template <int dim>
SavedRun<dim> saved_run(const std::string& text, const mesh::MeshData<dim>& mesh);

}  // namespace geneva::api
