#include "fem/surface_forces.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

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

/// K_e u_e - f_e
dealii::Vector<double> forces_of_cell(const CellSystem& cell,
                                      const dealii::TrilinosWrappers::MPI::Vector& displacement) {
  dealii::Vector<double> of_nodes(cell.load.size());
  for (unsigned int i = 0; i < of_nodes.size(); ++i) of_nodes[i] = displacement(cell.dofs[i]);
  dealii::Vector<double> forces(cell.load.size());
  cell.stiffness.vmult(forces, of_nodes);
  forces -= cell.load;
  return forces;
}

}  // namespace

ForcedUnknowns forced_unknowns(const std::set<Dof>& dofs, const std::vector<CellSystem>& cells,
                               const dealii::AffineConstraints<double>& hanging) {
  ForcedUnknowns result{{dofs.begin(), dofs.end()}, {}};
  if (dofs.empty()) return result;
  std::vector<bool> is_forced(*dofs.rbegin() + 1, false);  // a search for every cell takes longer
  for (const Dof dof : dofs) is_forced[dof] = true;
  for (std::size_t index = 0; index < cells.size(); ++index) {
    bool has_share = false;
    for (const Dof dof : cells[index].dofs)
      visit_carriers(hanging, dof, [&](const Dof carrier, double) {
        has_share = has_share || (carrier < is_forced.size() && is_forced[carrier]);
      });
    if (has_share) result.cells.push_back(index);
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
                             const dealii::AffineConstraints<double>& hanging,
                             const dealii::TrilinosWrappers::MPI::Vector& displacement) {
  std::vector<double> shares(unknowns.dofs.size(), 0.);
  for (const std::size_t index : unknowns.cells) {
    const CellSystem& cell = cells[index];
    const dealii::Vector<double> forces = forces_of_cell(cell, displacement);
    for (unsigned int i = 0; i < forces.size(); ++i)
      visit_carriers(hanging, cell.dofs[i], [&](const Dof carrier, const double share) {
        if (const auto place = place_in(unknowns.dofs, carrier))
          shares[*place] += share * forces[i];
      });
  }
  std::vector<double> sums(shares.size());
  dealii::Utilities::MPI::sum(shares, displacement.get_mpi_communicator(), sums);
  return {unknowns.dofs, std::move(sums)};
}

}  // namespace geneva::fem
