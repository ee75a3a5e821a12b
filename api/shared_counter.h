#pragma once

#include <mpi.h>

#include <cstddef>
#include <optional>

namespace geneva::api {

/// Hands out 0, 1, 2, ... once each to whichever rank asks next, so that ranks whose work takes
/// long take less of it.
class SharedCounter {
 public:
  /// Collective.
  explicit SharedCounter(MPI_Comm communicator);
  /// Collective.
  ~SharedCounter();
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter(SharedCounter&&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  SharedCounter& operator=(SharedCounter&&) = delete;

  [[nodiscard]] std::size_t next();

 private:
  std::optional<MPI_Win> window_;  ///< none with one rank, which may have no transport for it
  std::size_t own_ = 0;            ///< of one rank
};

}  // namespace geneva::api
