#include "fem/elasticity/surface_forces.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fem/elasticity/marked_unknowns.h"

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

/// A cell's part in forces, by their places: how much of the force at each of its unknowns.
using Parts = std::map<std::size_t, std::vector<std::pair<unsigned int, double>>>;

Parts parts_of(const CellSystems::Dofs& dofs, const std::vector<Dof>& forced_dofs,
               const MarkedUnknowns& forced, const dealii::AffineConstraints<double>& hanging) {
  Parts parts;
  for (unsigned int i = 0; i < dofs.size(); ++i)
    visit_carriers(hanging, dofs[i], [&](const Dof carrier, const double part) {
      if (forced.have(carrier)) parts[*place_in(forced_dofs, carrier)].emplace_back(i, part);
    });
  return parts;
}

ForcedUnknowns::Cell forced_cell(const CellSystem& system, const Parts& parts) {
  ForcedUnknowns::Cell cell{system.dofs, {}};
  for (const auto& [in, unknowns] : parts) {
    ForcedUnknowns::Share share{in, std::vector<double>(system.dofs.size(), 0.), 0.};
    for (const auto& [i, part] : unknowns) {
      share.load += part * system.load[i];
      for (unsigned int j = 0; j < share.stiffness.size(); ++j)
        share.stiffness[j] += part * system.stiffness(i, j);
    }
    cell.shares.push_back(std::move(share));
  }
  return cell;
}

}  // namespace

ForcedUnknowns forced_unknowns(const std::set<Dof>& dofs, const CellSystems& cells,
                               const dealii::AffineConstraints<double>& hanging) {
  ForcedUnknowns result{{dofs.begin(), dofs.end()}, {}};
  const MarkedUnknowns forced(dofs);
  for (std::size_t index = 0; index < cells.size(); ++index) {
    const Parts parts = parts_of(cells.dofs(index), result.dofs, forced, hanging);
    if (!parts.empty()) result.cells.push_back(forced_cell(cells[index], parts));
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

SurfaceForces surface_forces(const ForcedUnknowns& unknowns, const Vector& displacement) {
  std::vector<double> shares(unknowns.dofs.size(), 0.);
  std::vector<double> displacements;
  for (const ForcedUnknowns::Cell& cell : unknowns.cells) {
    displacements.resize(cell.dofs.size());
    displacement.extract_subvector_to(cell.dofs, displacements);
    for (const auto& [in, stiffness, load] : cell.shares)
      shares[in] +=
          std::inner_product(stiffness.begin(), stiffness.end(), displacements.begin(), -load);
  }
  std::vector<double> sums(shares.size());
  dealii::Utilities::MPI::sum(shares, displacement.get_mpi_communicator(), sums);
  return {unknowns.dofs, std::move(sums)};
}

}  // namespace geneva::fem
