#pragma once

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <string>

#include "api/case.h"
#include "api/written.h"
#include "app/progress.h"

namespace geneva::app {

/// What commands share that solve a case, and variants of it, and then write one document. All
/// ranks make one and call it.
class SolvingCommand {
 public:
  /// Reads the case, and sees that its results can be written.
  /// @param output where they go; empty: results in the case's directory
  /// @throws base::InputError on all ranks
  SolvingCommand(MPI_Comm communicator, const std::filesystem::path& case_directory,
                 const std::filesystem::path& output);

  [[nodiscard]] const Case& given() const { return given_; }
  [[nodiscard]] ProgressDisplay& progress() { return progress_; }

  /// Writes the results, on rank 0, and says what went where.
  /// @param files as they are told: "crown.json and report.html"
  void write(const std::function<Written(const std::filesystem::path&)>& write_into,
             const std::string& files);
  /// Says so if the accuracy was not reached.
  /// @return exit code
  int end(bool is_accurate);

 private:
  MPI_Comm communicator_;
  bool is_first_;
  Case given_;
  std::filesystem::path directory_;
  ProgressDisplay progress_;
};

}  // namespace geneva::app
