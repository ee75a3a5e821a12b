#include "fem/surface_forces.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fem/marked_unknowns.h"

namespace geneva::fem {

namespace {

using Dof = dealii::types::global_dof_index;

/// Calls visit(dof, share) for the unknowns that carry a force at an unknown: those that it hangs
/// on, or itself.
template <typename Visit>
void visit_carriers(const dealii::AffineConstraints<double>& hanging, const Dof dof,
                    const Visit& visit) {
  if (const auto* const entries = hanging.get_constraint_entries(dof))
    for (const auto& [carrier, share] : *entries) visit(carrier, share);
  else
    visit(dof, 1.);
}

std::optional<std::size_t> place_in(const std::vector<Dof>& dofs, const Dof dof) {
  const auto found = std::lower_bound(dofs.begin(), dofs.end(), dof);
  if (found == dofs.end() || *found != dof) return std::nullopt;
  return static_cast<std::size_t>(found - dofs.begin());
}

/// K_e u_e - f_e at one of the cell's unknowns.
double force_of_cell(const CellSystem& cell, const unsigned int at,
                     const std::vector<double>& displacements) {
  double force = -cell.load[at];
  for (unsigned int j = 0; j < displacements.size(); ++j)
    force += cell.stiffness(at, j) * displacements[j];
  return force;
}

}  // namespace

ForcedUnknowns forced_unknowns(const std::set<Dof>& dofs, const std::vector<CellSystem>& cells,
                               const dealii::AffineConstraints<double>& hanging) {
  ForcedUnknowns result{{dofs.begin(), dofs.end()}, {}};
  const MarkedUnknowns forced(dofs);
  for (std::size_t index = 0; index < cells.size(); ++index) {
    std::vector<ForcedUnknowns::Share> shares;
    for (unsigned int i = 0; i < cells[index].dofs.size(); ++i)
      visit_carriers(hanging, cells[index].dofs[i], [&](const Dof carrier, const double share) {
        if (forced.have(carrier)) shares.push_back({i, *place_in(result.dofs, carrier), share});
      });
    if (!shares.empty()) result.cells.push_back({index, std::move(shares)});
  }
  return result;
}

SurfaceForces::SurfaceForces(std::vector<Dof> dofs, std::vector<double> values)
    : dofs_(std::move(dofs)), values_(std::move(values)) {}

double SurfaceForces::operator()(const Dof dof) const {
  const auto place = place_in(dofs_, dof);
  if (!place)
    throw std::out_of_range(
        fmt::format("no contact, support or tie exerts a force at unknown {}", dof));
  return values_[*place];
}

SurfaceForces surface_forces(const ForcedUnknowns& unknowns, const std::vector<CellSystem>& cells,
                             const dealii::TrilinosWrappers::MPI::Vector& displacement) {
  std::vector<double> shares(unknowns.dofs.size(), 0.);
  std::vector<double> displacements;
  for (const ForcedUnknowns::Cell& forced : unknowns.cells) {
    const CellSystem& cell = cells[forced.index];
    displacements.resize(cell.dofs.size());
    displacement.extract_subvector_to(cell.dofs, displacements);
    for (const auto& [of, in, share] : forced.shares)
      shares[in] += share * force_of_cell(cell, of, displacements);
  }
  std::vector<double> sums(shares.size());
  dealii::Utilities::MPI::sum(shares, displacement.get_mpi_communicator(), sums);
  return {unknowns.dofs, std::move(sums)};
}

}  // namespace geneva::fem
