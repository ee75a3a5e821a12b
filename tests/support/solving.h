#pragma once

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "fem/contact_problem.h"
#include "post/analysis/results.h"
#include "tests/support/line_contact.h"

namespace geneva::test {

/// True on the rank that prints.
inline bool prints() { return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0; }

inline fem::Settings with_accuracy(const double accuracy) {
  fem::Settings settings;
  settings.accuracy = accuracy;
  return settings;
}

inline fem::Solution<2> solve(const mesh::MeshData<2>& mesh, const fem::Problem<2>& problem,
                              const fem::Settings& settings = {}) {
  return fem::solve_contact(MPI_COMM_WORLD, mesh, problem, settings, {});
}

inline fem::Solution<2> solve(const LineContact& contact, const fem::Settings& settings = {}) {
  return solve(mesh_of(contact), problem_of(contact), settings);
}

inline double peak_pressure(const fem::Solution<2>& solution) {
  return solution.contacts.front().peak_pressure;
}

/// Relative difference of a value from what it should be.
inline double error_of(const double value, const double exact) { return value / exact - 1.; }

/// Maximum difference of the nodes' pressure from Hertz's for |x| < share b, as a share of p0;
/// x is counted from the centre of pressure.
inline double pressure_deviation(const fem::Solution<2>& solution, const loads::HertzLine& hertz,
                                 const double share) {
  const fem::ContactResult<2>& contact = solution.contacts.front();
  const double centre = post::pressure_centre(solution, contact).arc_length;
  double maximum = 0.;
  for (const fem::ContactNode<2>& node : contact.nodes) {
    const double x = node.arc_length - centre;
    if (std::abs(x) >= share * hertz.half_width) continue;
    maximum = std::max(maximum, std::abs(node.pressure - hertz.pressure(x)));
  }
  return maximum / hertz.peak_pressure;
}

/// Longest over shortest distance of neighbouring nodes in contact.
inline double unevenness(const fem::ContactResult<2>& contact) {
  double longest = 0.;
  double shortest = 1e300;
  for (std::size_t i = 1; i < contact.nodes.size(); ++i) {
    if (!is_closed(contact.nodes[i].status) || !is_closed(contact.nodes[i - 1].status)) continue;
    const double step = contact.nodes[i].arc_length - contact.nodes[i - 1].arc_length;
    longest = std::max(longest, step);
    shortest = std::min(shortest, step);
  }
  return longest / shortest;
}

}  // namespace geneva::test
