#pragma once

#include <mpi.h>

#include <filesystem>
#include <optional>
#include <string>

#include "api/analysis.h"
#include "api/output_directory.h"
#include "api/written.h"

namespace geneva::api {

template <int dim>
struct AnalysedModel;

/// Where the results of an analysis go. Made before it, so that what cannot be written is refused
/// before hours of computation and not after.
class AnalysisOutput {
 public:
  /// All ranks call it.
  /// @throws base::InputError on all ranks if the directory cannot be replaced, another run does
  /// so, or the disk is too full even for the smallest results
  AnalysisOutput(MPI_Comm communicator, const Case& given, const std::filesystem::path& directory);

  /// Writes all files and puts them in their place. All ranks call it.
  /// @param log of what the user was told, on rank 0
  /// @param checkpoint of the last mesh, on rank 0; may be empty
  /// @throws base::InputError on all ranks if something cannot be written; the directory is then as
  /// it was
  Written write(const Analysis& analysis, const std::string& log, const std::string& checkpoint);

 private:
  template <int dim>
  Written write(const Analysis& analysis, const AnalysedModel<dim>& analysed,
                const std::string& log, const std::string& checkpoint);

  MPI_Comm communicator_;
  bool is_first_;
  std::optional<OutputDirectory> directory_;
};

}  // namespace geneva::api
