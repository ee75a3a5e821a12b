#include "model/stop_message.h"

#include <fmt/format.h>

namespace geneva::model {

std::string message_of(const fem::Stop& stop) {
  using Outcome = fem::Outcome;
  switch (stop.outcome) {
    case Outcome::converged:
      return "";
    case Outcome::unbounded_edge:
      return fmt::format(
          "the edge pressure is not bounded: sharp edge (it grows by the power {:.2g} of the "
          "cells' fineness); the pressure in the middle of the length has converged; a chamfered "
          "or rounded slot edge, a crowned pin or a logarithmic profile bounds it",
          stop.growth);
    case Outcome::unbounded_pressure:
      return "the peak pressure grows by more than 10 % from each mesh to the next: the contact "
             "reaches a sharp edge, where the pressure of linear elasticity is singular; round the "
             "edge in the geometry, or move the contact away from it";
    case Outcome::no_progress:
      return "over the last three refinements of the contact zone neither the number of nodes in "
             "contact grew nor the pressure changed: finer meshes will not help; check supports "
             "and loads, or draw another coarse mesh at the contact";
    case Outcome::refinement_limit:
      return fmt::format(
          "the limit of {:.0f} refinement levels was reached; raise 'Maximum refinement levels'",
          stop.limit);
    case Outcome::dof_limit:
      return fmt::format(
          "the next mesh would have about {:.0f} unknowns, the limit is {:.0f}; "
          "raise 'Maximum unknowns'",
          stop.needed, stop.limit);
    case Outcome::coarse_dof_limit:
      return fmt::format(
          "the coarse mesh has {:.0f} unknowns already, the limit is {:.0f}; raise 'Maximum "
          "unknowns', or check the dimensions: lengths of very different sizes take many cells",
          stop.needed, stop.limit);
    case Outcome::memory_limit:
      return fmt::format(
          "the next mesh would need about {:.0f} MB, the memory limit is {:.0f} MB; "
          "raise 'Maximum memory'",
          stop.needed / 1e6, stop.limit / 1e6);
    case Outcome::out_of_memory:
      return fmt::format(
          "memory ran out on a mesh of {} unknowns; give the program more of it (other programs, "
          "ulimit, the limit of a container)",
          stop.unknowns);
    case Outcome::time_limit:
      return fmt::format(
          "the next mesh would be solved after about {:.2g} s, the time limit is "
          "{:.2g} s; raise 'Maximum time'",
          stop.needed, stop.limit);
    case Outcome::active_set_limit:
      return fmt::format(
          "the active set did not settle within {:.0f} steps on a mesh of {} unknowns; raise "
          "'Maximum active-set steps', or check that supports and contact pairs hold every body",
          stop.limit, stop.unknowns);
    case Outcome::slides:
      return fmt::format(
          "everything slides in load step {}: to hold the bodies, the friction of contact pair {} "
          "would have to be {:.4g} N, and its coefficient allows {:.4g} N under the normal force "
          "there; reduce the load along the surfaces, raise 'Friction coefficient', or give a "
          "support",
          stop.step + 1, stop.pair + 1, stop.needed, stop.limit);
    case Outcome::linear_solver:
      return fmt::format(
          "the linear solver did not converge on a mesh of {} unknowns (residual {:.2e} after "
          "{:.0f} iterations); check that supports and contact pairs hold every body",
          stop.unknowns, stop.residual, stop.needed);
  }
  return "";
}

}  // namespace geneva::model
