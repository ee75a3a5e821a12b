#pragma once

#include <mpi.h>

#include <optional>
#include <vector>

#include "api/case.h"
#include "post/output/cycle_fields.h"
#include "post/output/cycle_output.h"
#include "post/output/envelope.h"

namespace geneva::api {

/// What is greatest over the engagements.
struct CycleEnvelope {
  post::NodalFields
      nodes;  ///< of the instant with the greatest pressure, with more where it passes
  post::Envelope greatest;
  std::optional<post::PressureEnvelope> pressure;  ///< none: not known
};

/// What the greatest tensile stresses go through, the same on all ranks; all of them call it.
/// @param fields of the instants, on rank 0
std::vector<post::Swing> swings_of(MPI_Comm communicator, const Case& given,
                                   const post::CycleReport& report,
                                   const std::vector<post::CycleFields>& fields);

/// The ranks share its nodes; all of them call it.
/// @param report with its curve
/// @param fields of the instants, on rank 0
/// @return on rank 0, without content on the others; none if the instant with the greatest pressure
/// was not solved
std::optional<CycleEnvelope> cycle_envelope(MPI_Comm communicator, const Case& given,
                                            const post::CycleReport& report,
                                            const std::vector<post::CycleFields>& fields);

}  // namespace geneva::api
