#include "fem/condensation.h"

#include <algorithm>
#include <map>

namespace geneva::fem {

namespace {

using dealii::types::global_dof_index;
using Constraints = dealii::AffineConstraints<double>;

/// The unknowns that a cell's unknowns depend on, with their places in the condensed system.
std::map<global_dof_index, unsigned int> free_unknowns(const std::vector<global_dof_index>& dofs,
                                                       const Constraints& constraints) {
  std::map<global_dof_index, unsigned int> places;
  for (const global_dof_index dof : dofs)
    if (const auto* entries = constraints.get_constraint_entries(dof))
      for (const auto& [other, weight] : *entries) places.emplace(other, 0);
    else
      places.emplace(dof, 0);
  unsigned int place = 0;
  for (auto& entry : places) entry.second = place++;
  return places;
}

/// Whether the constraint of an unknown is the same in both; it is constrained in the first.
bool is_same(const Constraints::ConstraintLine& line, const Constraints& other) {
  const auto* entries = other.get_constraint_entries(line.index);
  return entries != nullptr && *entries == line.entries &&
         other.get_inhomogeneity(line.index) == line.inhomogeneity;
}

}  // namespace

CellSystem condensed(const CellSystem& cell, const Constraints& constraints) {
  const auto places = free_unknowns(cell.dofs, constraints);
  const auto n_dofs = static_cast<unsigned int>(cell.dofs.size());
  const auto n_free = static_cast<unsigned int>(places.size());
  dealii::FullMatrix<double> dependence(n_dofs, n_free);  // C
  dealii::Vector<double> prescribed(n_dofs);              // g
  for (unsigned int i = 0; i < n_dofs; ++i)
    if (const auto* entries = constraints.get_constraint_entries(cell.dofs[i])) {
      for (const auto& [dof, weight] : *entries) dependence(i, places.at(dof)) += weight;
      prescribed[i] = constraints.get_inhomogeneity(cell.dofs[i]);
    } else {
      dependence(i, places.at(cell.dofs[i])) = 1.;
    }
  CellSystem result{dealii::FullMatrix<double>(n_free), dealii::Vector<double>(n_free), {}};
  for (const auto& [dof, place] : places) result.dofs.push_back(dof);
  result.stiffness.triple_product(cell.stiffness, dependence, dependence, true, false);
  dealii::Vector<double> load(n_dofs);
  cell.stiffness.vmult(load, prescribed);
  load.sadd(-1., cell.load);
  dependence.Tvmult(result.load, load);
  return result;
}

std::set<global_dof_index> changed_unknowns(const Constraints& before, const Constraints& after) {
  std::set<global_dof_index> changed;
  for (const auto& line : before.get_lines())
    if (!is_same(line, after)) changed.insert(line.index);
  for (const auto& line : after.get_lines())
    if (!is_same(line, before)) changed.insert(line.index);
  return changed;
}

}  // namespace geneva::fem
