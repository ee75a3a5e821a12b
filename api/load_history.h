#pragma once

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "api/analysis.h"
#include "api/case.h"
#include "api/written.h"
#include "post/output/cycle_fields.h"
#include "post/output/envelope.h"
#include "post/output/load_history_output.h"

namespace geneva {

/// A geometry case over its load steps.
struct LoadHistory {
  Case given;
  bool is_converged;  ///< whether the last step has the accuracy that the case asks for
  post::LoadHistoryReport report;
  std::vector<post::CycleFields> fields;    ///< by step, on rank 0
  post::PressureEnvelope contact_pressure;  ///< at the nodes of source surfaces, on rank 0
};

/// Solves the contact as `geneva run` does, and keeps what it finds at every load step of the last
/// mesh.
/// @param mesher already started, on rank 0; may be null
/// @throws InputError if the case has no load steps, or cannot be solved
LoadHistory load_history(const Case& given, MPI_Comm communicator, mesh::Mesher* mesher,
                         const Progress& progress);

/// The steps and what is greatest, as `geneva cycle` prints them, in the case's units.
std::string table(const LoadHistory& history);

/// Writes load_steps.json, load_steps.csv, the fields of the steps (load_steps.pvd), their envelope
/// and the report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const LoadHistory& history, const std::filesystem::path& directory);

}  // namespace geneva
