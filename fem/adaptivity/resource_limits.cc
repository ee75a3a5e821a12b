#include "fem/adaptivity/resource_limits.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <fstream>

namespace geneva::fem {

double peak_memory(const MPI_Comm communicator) {
  dealii::Utilities::System::MemoryStats memory{};
  dealii::Utilities::System::get_memory_stats(memory);
  return dealii::Utilities::MPI::sum(1024. * static_cast<double>(memory.VmHWM), communicator);
}

namespace {

/// From here on the maximum memory is that since now: an earlier solve in this process may have
/// taken more. See proc(5), /proc/pid/clear_refs; where the system refuses, all counts.
double memory_now(const MPI_Comm communicator) {
  std::ofstream("/proc/self/clear_refs") << "5";
  return peak_memory(communicator);
}

}  // namespace

ResourceLimits::ResourceLimits(const MPI_Comm communicator, const Settings& settings)
    : communicator_(communicator),
      settings_(settings),
      memory_at_start_(memory_now(communicator)) {}

std::optional<Stop> ResourceLimits::exceeded_by_next(const double growth,
                                                     const std::vector<LevelRecord>& history,
                                                     const double seconds_before) const {
  if (const auto stop = exceeded_by(growth * history.back().dofs)) return stop;
  const double memory = memory_at_start_ + growth * (peak_memory(communicator_) - memory_at_start_);
  if (memory > settings_.max_memory)
    return stop_at_limit(Outcome::memory_limit, memory, settings_.max_memory);
  const double previous = history.size() > 1 ? history[history.size() - 2].seconds : 0.;
  const double own =
      history.back().seconds + growth * (history.back().seconds - previous) - seconds_before;
  const double seconds = dealii::Utilities::MPI::max(own, communicator_);
  if (seconds > settings_.max_seconds)
    return stop_at_limit(Outcome::time_limit, seconds, settings_.max_seconds);
  return std::nullopt;
}

std::optional<Stop> ResourceLimits::exceeded_by(const double unknowns) const {
  if (unknowns <= settings_.max_dofs) return std::nullopt;
  return stop_at_limit(Outcome::dof_limit, unknowns, settings_.max_dofs);
}

}  // namespace geneva::fem
