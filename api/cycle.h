#pragma once

#include <mpi.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/case.h"
#include "api/cycle_envelope.h"
#include "api/written.h"
#include "post/output/cycle_fields.h"
#include "post/output/cycle_output.h"

namespace geneva {

namespace mesh {
class Mesher;
}

/// A mechanism over its engagements.
struct Cycle {
  Case given;
  bool is_converged;  ///< whether every instant has the accuracy that the case asks for
  post::CycleReport report;
  std::vector<post::CycleFields> fields;       ///< of the instants that were solved, on rank 0
  std::optional<api::CycleEnvelope> envelope;  ///< on rank 0; none without a greatest pressure
};

/// Solves the contact at the instants that stand for the engagements, on whichever wall carries;
/// the ranks share the instants.
/// @param mesher already started, on rank 0; may be null
/// @param tell after an instant, on the rank that solved it; may be empty. What it throws ends the
/// cycle, see end_together(); other ranks end the instants that they are at
/// @throws InputError if the case is no mechanism, or nothing ever presses
Cycle cycle(
    const Case& given, MPI_Comm communicator, mesh::Mesher* mesher,
    const std::function<void(const post::CyclePoint&, std::size_t done, std::size_t of)>& tell);

/// The instants and what is greatest, as `geneva cycle` prints them, in the case's units.
std::string table(const Cycle& cycle);

/// Writes cycle.json, cycle.csv, the fields of the instants (cycle.pvd), their envelope and the
/// report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Cycle& cycle, const std::filesystem::path& directory);

}  // namespace geneva
